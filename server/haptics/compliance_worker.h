#pragma once
// Worker thread that computes how compliant bodies are where hands press them, so that no tick waits for the
// result. It starts with the first question.

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "server/haptics/compliance.h"

namespace prosector {

/// Description, meshes and attachments of a soft body, from which the worker thread makes its copy.
struct BodyCopy {
  SoftDesc desc;
  Anatomy anatomy;
  VecX ties;
};

/// Request to compute the stiffness that hands feel at one body's contact patches. The caller numbers the
/// patches in `names`, and the answer refers to these numbers.
struct ComplianceQuestion {
  BodyId body = 0;
  std::uint64_t version = 0;                  // of the body's mesh and ties
  std::shared_ptr<const BodyCopy> copy = {};  // body of that version; null: the worker has it already
  VecX x;
  double strength = 1;
  std::vector<Support> supports;
  std::vector<Patch> patches;
  std::vector<std::uint64_t> names;  // names of the patches, in the same order
};

struct ComplianceAnswer {
  BodyId body = 0;
  std::uint64_t version = 0;
  std::vector<std::uint64_t> names;
  std::vector<Slopes> found;  // by name; empty: could not be computed
};

class ComplianceWorker {
 public:
  ComplianceWorker() = default;
  ~ComplianceWorker();

  bool busy() const;
  /// Submits a request to the worker thread. Returns false, and drops the request, if the worker is busy.
  bool ask(ComplianceQuestion question);
  /// Returns the answers that the worker thread has finished since the last call.
  std::vector<ComplianceAnswer> take();

 private:
  void run(std::stop_token stop);
  ComplianceAnswer answer(ComplianceQuestion question);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<ComplianceQuestion> question_;
  std::vector<ComplianceAnswer> answers_;
  bool working_ = false;
  // Used by the worker thread only:
  struct Known {
    std::uint64_t version;
    std::unique_ptr<TissueCompliance> compliance;
  };
  std::map<BodyId, Known> known_;
  std::jthread thread_;
};

}  // namespace prosector
