#pragma once

// What Windows and POSIX systems do each in their own way.
namespace rtg
{

/// Lets others go before this thread and, on Linux, before those that it starts.
void LowerPriority();

} // namespace rtg
