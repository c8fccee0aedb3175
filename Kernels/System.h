#pragma once

// What Windows and POSIX systems do each in their own way.
namespace rtg
{

/// Lets others go before this thread and, on Linux, before those that it starts.
void LowerPriority();

/// Sets a variable of the process's environment.
void SetEnvironment(const char* name, const char* value);

/// Whether the processor has the instructions of AVX-512 that lavapipe's compiler uses.
bool HasAvx512();

} // namespace rtg
