#include "server/haptics/compliance_worker.h"

#include <exception>
#include <utility>

namespace prosector {

ComplianceWorker::~ComplianceWorker() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

bool ComplianceWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || question_.has_value();
}

bool ComplianceWorker::ask(ComplianceQuestion question) {
  {
    const std::lock_guard lock(mutex_);
    if (working_ || question_) return false;
    question_ = std::move(question);
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
  changed_.notify_all();
  return true;
}

std::vector<ComplianceAnswer> ComplianceWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answers_, {});
}

void ComplianceWorker::run(std::stop_token stop) {
  for (;;) {
    ComplianceQuestion question;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return question_.has_value(); })) return;
      question = std::move(*question_);
      question_.reset();
      working_ = true;
    }
    ComplianceAnswer found = answer(std::move(question));
    const std::lock_guard lock(mutex_);
    answers_.push_back(std::move(found));
    working_ = false;
  }
}

/// Computes the slopes. Returns an empty result if the worker does not have that version of the body, or if
/// the computation throws: an error here must not end the session.
ComplianceAnswer ComplianceWorker::answer(ComplianceQuestion question) {
  ComplianceAnswer out{question.body, question.version, std::move(question.names), {}};
  try {
    Known& known = known_[question.body];
    if (question.copy)
      known = {question.version, std::make_unique<TissueCompliance>(
                                     question.copy->desc, question.copy->anatomy, question.copy->ties)};
    if (known.compliance && known.version == question.version)
      out.found = known.compliance->find(question.x, question.strength, question.supports, question.patches);
  } catch (const std::exception&) {
    known_.erase(question.body);
  }
  return out;
}

}  // namespace prosector
