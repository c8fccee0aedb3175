#pragma once

#include <filesystem>

// What Windows and POSIX systems do each in their own way.
namespace rtg
{

/// The folder that an environment variable names; empty: none.
std::filesystem::path FolderOfVariable(const char* variable);

/// The folder in which programs of this user keep what can be made again; empty: none.
std::filesystem::path CacheFolderOfUser();

/// Lets others go before this thread and, on Linux, before those that it starts.
void LowerPriority();

} // namespace rtg
