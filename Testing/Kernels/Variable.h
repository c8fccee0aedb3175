// An environment variable that has another value, or none, while the object lives.
#pragma once

#include <cstdlib>
#include <string>

namespace rtg::testing
{

class Variable
{
public:
  Variable(const char* name, const char* value)
    : name_(name)
  {
    const char* before = std::getenv(name);
    this->had_ = before != nullptr;
    this->before_ = before ? before : "";
    Set(name, value);
  }
  ~Variable() { Set(this->name_, this->had_ ? this->before_.c_str() : nullptr); }

private:
  static void Set(const char* name, const char* value)
  {
#ifdef _WIN32
    _putenv_s(name, value ? value : "");
#else
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
#endif
  }

  const char* name_;
  bool had_ = false;
  std::string before_;
};

} // namespace rtg::testing
