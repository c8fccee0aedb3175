/**
 * Makes something again only when what it depends on has changed.
 */
#ifndef RayTracedCache_h
#define RayTracedCache_h

#include <optional>
#include <utility>

namespace rtglyphs
{

template <class Key>
class RayTracedCache
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

  bool Holds(const Key& key) const { return this->Known == key; }

  void Forget() { this->Known.reset(); }

private:
  std::optional<Key> Known;
};

} // namespace rtglyphs

#endif
