#pragma once
// A thread that finds how far bodies give way where hands press them, so that no tick waits for it. There is
// none before the first question.

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "server/haptics/compliance.h"

namespace prosector {

/// What a copy of a body is made of, while it is that.
struct BodyCopy {
  SoftDesc desc;
  Anatomy anatomy;
  VecX ties;
};

/// A question about one body; patches are named by whoever asks.
struct ComplianceQuestion {
  BodyId body = 0;
  std::uint64_t version = 0;                  // of the body's mesh and ties
  std::shared_ptr<const BodyCopy> copy = {};  // of that version; null: the worker has it
  VecX x;
  double strength = 1;
  std::vector<Support> supports;
  std::vector<Patch> patches;
  std::vector<std::uint64_t> names;  // of the patches
};

struct ComplianceAnswer {
  BodyId body = 0;
  std::uint64_t version = 0;
  std::vector<std::uint64_t> names;
  std::vector<Slopes> found;  // by name; empty: nothing is known
};

class ComplianceWorker {
 public:
  ComplianceWorker() = default;
  ~ComplianceWorker();

  bool busy() const;
  /// Gives it a question, if it isn't busy; returns false if it is.
  bool ask(ComplianceQuestion question);
  /// Returns the answers since the last call.
  std::vector<ComplianceAnswer> take();

 private:
  void run(std::stop_token stop);
  ComplianceAnswer answer(ComplianceQuestion question);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<ComplianceQuestion> question_;
  std::vector<ComplianceAnswer> answers_;
  bool working_ = false;
  // The thread's own:
  struct Known {
    std::uint64_t version;
    std::unique_ptr<TissueCompliance> compliance;
  };
  std::map<BodyId, Known> known_;
  std::jthread thread_;
};

}  // namespace prosector
