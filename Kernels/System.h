#pragma once

// What Windows and POSIX systems do each in their own way.
namespace rtg
{

/// Lets others go before this thread and, on Linux, before those that it starts.
void LowerPriority();

/// Sets a variable of the process's environment.
void SetEnvironment(const char* name, const char* value);

} // namespace rtg
