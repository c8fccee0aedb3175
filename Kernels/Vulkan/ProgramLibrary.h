// The compiled programs of a device, each made once for all tracers.
#pragma once

#include "Pipeline.h"

#include <condition_variable>
#include <cstddef>
#include <future>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rtg
{

/// A pipeline, and what is known of the threads that compile it.
struct Program
{
  Specialization specialization;
  std::unique_ptr<Pipeline> pipeline; ///< null until `compiled` is ready, and after a failure
  std::promise<void> done;
  std::shared_future<void> compiled = done.get_future(); ///< throws what compiling failed of
  bool ahead = false;                                    ///< compiled by the thread of the lowest priority alone
};

/// Programs stay compiled while the device lives, so that a further view, or one that is made anew, has them at once.
class ProgramLibrary
{
public:
  explicit ProgramLibrary(Device::State& device);
  ~ProgramLibrary(); ///< waits for what is being compiled or saved
  ProgramLibrary(const ProgramLibrary&) = delete;
  ProgramLibrary& operator=(const ProgramLibrary&) = delete;

  /// The program of that key. True: compiling has begun with this call; again, if it failed before. In any thread.
  std::pair<std::shared_ptr<Program>, bool> Get(const Specialization& specialization);

  /// Compiles what there is none of yet, one program after the other, while the processor has nothing else to do. What
  /// was requested before and has not begun is forgotten.
  void CompileAhead(std::vector<Specialization> wanted);
  /// Programs that are still to be compiled ahead, the one in work among them.
  std::size_t Ahead();

private:
  std::shared_ptr<Program> Find(const Specialization& specialization);
  std::shared_ptr<Program> Add(const Specialization& specialization);
  void Compile(Program& program);
  void WorkAhead();

  Device::State* device_;
  std::mutex mutex_;
  std::size_t atWork_ = 0; ///< threads that compile or save
  std::condition_variable idle_;
  std::vector<std::shared_ptr<Program>> programs_; ///< last used last
  std::vector<Specialization> ahead_;              ///< to be compiled ahead, the next one last
  bool worksAhead_ = false;
};

} // namespace rtg
