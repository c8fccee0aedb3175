/**
 * Information on a view's last frame: its progress, samples and statistics, of all ranks that rendered it
 * together.
 */
#ifndef RayTracedFrameStatus_h
#define RayTracedFrameStatus_h

#include <cstdint>
#include <string>
#include <vector>

namespace rtglyphs
{
class RayTracedDisplays;
class RayTracedImages;

class RayTracedFrameStatus
{
public:
  /**
   * Of one frame, on one rank.
   */
  struct Frame
  {
    double Progress = 1.0; // the least of its images, in [0, 1]
    double Samples = 0.0;  // a pixel, the least of its images
    bool Compiling = false;
    bool Stereo = false;
    int Eye = 0; // 0 or 1
  };

  /**
   * Reduces the values of a frame over the ranks that rendered it together: to be called by all of them
   * at once, or else by this one alone.
   */
  void SetFrame(Frame frame, bool collective);

  /**
   * Nothing is waited for any more.
   */
  void Finish() { this->Eyes[0].Progress = this->Eyes[1].Progress = 1.0; }

  /**
   * The work that an unfinished frame waits for.
   */
  static const char* NameOfStep(bool compiling) { return compiling ? "Compiling Shaders" : "Ray Tracing"; }

  ///@{
  /**
   * Counts of glyphs, bytes and rays: of this rank, until they are summed over all. SumNumbers() is to be called by all
   * ranks at once.
   */
  void SumNumbers(const RayTracedDisplays& displays, const RayTracedImages& images);
  void ForgetSums() { this->SummedNumbers.clear(); }
  ///@}

  /**
   * JSON: the device; samples a pixel that all images of the last frame have; progress of that frame in [0, 1] (1:
   * another one would change nothing), and what it waits for; all counters; and as "representations" those of each, by
   * its vtkPVDataRepresentation::GetUniqueIdentifier(). Samples and progress are the least of both eyes and of all
   * ranks that rendered the frame together.
   */
  std::string GetStatistics(const RayTracedDisplays& displays, const RayTracedImages& images);

private:
  Frame Eyes[2]; // the last frame of each
  int Eye = 0;   // of the last frame
  // The view's numbers, then those of each display, of the last frame that ranks rendered together; or none.
  std::vector<double> SummedNumbers;
  std::uint64_t Pulls = 0; // of the statistics
};

} // namespace rtglyphs

#endif
