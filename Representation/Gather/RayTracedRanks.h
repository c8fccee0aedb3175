/**
 * Numbers that all ranks find together. When memory runs out on one of them, all give up at the same place: none waits
 * for what another one will never send.
 */
#ifndef RayTracedRanks_h
#define RayTracedRanks_h

#include <functional>
#include <new>
#include <vector>

class vtkMultiProcessController;

namespace rtglyphs::RayTracedRanks
{
/**
 * What together() throws on the ranks that had memory enough.
 */
struct FailedElsewhere : std::bad_alloc
{
};

/**
 * The controller of all ranks of this process group; null: there is only one.
 */
vtkMultiProcessController* Controller();

/**
 * To be called by all ranks at once: work() of each. Throws std::bad_alloc on all when that is thrown on any.
 */
void Together(const std::function<void()>& work);

///@{
/**
 * Of all ranks at once: vtkCommunicator's operations on the values, the largest, and all values, one rank after
 * another.
 */
void Reduce(std::vector<double>& values, int operation);
double Largest(double value);
std::vector<double> Gather(const std::vector<double>& own);
///@}
}

#endif
// VTK-HeaderTest-Exclude: RayTracedRanks.h
