/**
 * Ctrl+C while an image is traced. A Python interpreter only takes note of the signal and acts when it runs again,
 * which may be minutes later; while an object of this class lives Arrived() is true after the signal. It is passed on
 * when the object goes. Programs without a handler of their own are left alone: there the signal ends the program.
 */
#ifndef RayTracedSignal_h
#define RayTracedSignal_h

namespace rtglyphs
{

class RayTracedSignal
{
public:
  RayTracedSignal();
  ~RayTracedSignal();
  RayTracedSignal(const RayTracedSignal&) = delete;
  RayTracedSignal& operator=(const RayTracedSignal&) = delete;

  bool Arrived() const;

private:
  using Handler = void (*)(int);
  Handler Before = nullptr;
};

} // namespace rtglyphs

#endif
