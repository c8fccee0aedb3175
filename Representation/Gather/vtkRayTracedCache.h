/**
 * Makes something again only when what it depends on has changed.
 */
#ifndef vtkRayTracedCache_h
#define vtkRayTracedCache_h

#include <optional>
#include <utility>

template <class Key>
class vtkRayTracedCache
{
public:
  /**
   * Calls make() unless it has been called for this key last, and returned. Whether it has called it.
   */
  template <class Make>
  bool Update(Key key, const Make& make)
  {
    if (this->Known == key)
    {
      return false;
    }
    this->Known.reset(); // make() may throw
    make();
    this->Known = std::move(key);
    return true;
  }

  void Forget() { this->Known.reset(); }

private:
  std::optional<Key> Known;
};

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedCache.h
