/**
 * Reductions over all ranks. When one of them fails, such as memory that runs out, all give up at
 * the same place: none waits for what another one will never send.
 */
#ifndef RayTracedRanks_h
#define RayTracedRanks_h

#include "vtkBoundingBox.h"

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace rtglyphs::RayTracedRanks
{
/**
 * Thrown by Together() on the ranks that did not fail.
 */
struct FailedElsewhere : std::exception
{
};

///@{
/**
 * How many ranks this process group has, and which of them this process is.
 */
int Count();
int Own();
///@}

///@{
/**
 * To be called by all ranks at once: work() of each, which may throw. When it does on any, Together() throws on all.
 * Problem() returns what was thrown on this rank instead; empty: nothing.
 */
void Together(const std::function<void()>& work);
std::string Problem(const std::function<void()>& work);
///@}

///@{
/**
 * Of all ranks at once; within Together() they agree first that nothing has gone wrong. vtkCommunicator's operations on
 * the values; the largest; the bounds of all; all values, one rank after another; the texts of each rank, none of which
 * is empty.
 */
template <class Value> // double, unsigned char
void Reduce(std::vector<Value>& values, int operation);
double Largest(double value);
vtkBoundingBox Union(const vtkBoundingBox& own);
std::vector<double> Gather(const std::vector<double>& own);
std::vector<std::vector<std::string>> Gather(const std::vector<std::string>& own);
///@}

/**
 * The same of messages[i], which goes to rank i: what has come, from rank after rank.
 */
std::vector<char> Exchange(std::vector<std::vector<char>> messages);
}

#endif
