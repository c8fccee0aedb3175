/**
 * Bytes that each rank sends to each other one.
 */
#ifndef RayTracedExchange_h
#define RayTracedExchange_h

#include <functional>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace rtglyphs
{

struct RayTracedExchange
{
  /// What has come, from rank after rank.
  std::vector<char> Bytes;

  /// What has gone wrong on this rank; empty: nothing.
  std::string Problem;

  /**
   * Does work that may throw; what it throws is the problem.
   */
  void Try(const std::function<void()>& work);

  /**
   * To be called by all ranks at once, whatever has gone wrong on them: messages[i] goes to rank i. Returns false when
   * something has gone wrong on any rank, and nothing was sent.
   */
  bool Send(vtkMultiProcessController* controller, std::vector<std::vector<char>> messages);
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedExchange.h
