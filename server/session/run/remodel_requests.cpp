#include "server/session/run/remodel_requests.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "server/physics/stations/save/take_over.h"

namespace prosector {

RemodelRequests::RemodelRequests(const Simulation& simulation, Remodeller* remodeller,
                                 std::function<void(const std::string&)> say)
    : simulation_(simulation), remodeller_(remodeller), say_(std::move(say)) {}

void RemodelRequests::pass_on(Session& session, BodyReports& bodies) {
  if (remodeller_ == nullptr) return;
  for (const auto& [participant, wanted] : session.requests().take_accuracies()) {
    const std::string& name = simulation_.name(wanted.body);
    if (wanted.percent > 0 && simulation_.revision(wanted.body) > 0)
      session.output().tell(participant, cut_stays(name).why());
    else
      remodeller_->ask({participant, wanted.body, name, wanted.percent});
  }
  std::vector<AccuracyAnswer> answers = remodeller_->take_answers();
  if (!answers.empty()) set_prices(bodies);
  std::move(answers.begin(), answers.end(), std::back_inserter(unheard_));
  std::erase_if(unheard_, [&](const AccuracyAnswer& answer) {
    if (!session.roster().members().contains(answer.wish.asker)) return false;
    say_(answer.words);
    session.output().tell(answer.wish.asker, answer.words);
    return true;
  });
}

void RemodelRequests::set_prices(BodyReports& bodies) const {
  if (remodeller_ == nullptr) return;
  const auto prices = remodeller_->prices();
  for (BodyId body = 0; body < simulation_.body_count(); ++body)
    if (const auto known = prices.find(simulation_.name(body)); known != prices.end())
      bodies.set_prices(body, known->second);
}

}  // namespace prosector
