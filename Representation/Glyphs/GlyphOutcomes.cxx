#include "GlyphOutcomes.h"

#include "GlyphSettings.h"
#include "RayTracedArrays.h"

#include <cmath>
#include <limits>
#include <sstream>

//----------------------------------------------------------------------------
vtkIdType rtglyphs::GlyphOutcomes::Describe(const Counts& counts, const rtglyphs::GlyphSettings& settings,
  std::size_t candidates, std::vector<std::string>& messages)
{
  vtkIdType skipped = counts[MISSING_ARRAY];
  const auto say = [&](vtkIdType count, const std::string& why, const std::string& remedy)
  {
    if (count > 0)
    {
      std::ostringstream text;
      text << count << " of " << candidates << " points have no glyph: " << why << ". " << remedy;
      messages.push_back(text.str());
      skipped += count;
    }
  };
  // Of zeros only where nothing else is left.
  const auto sayOfZeros = [&](vtkIdType count, const std::string& why, const std::string& remedy)
  {
    if (counts[SHOWN] == 0)
    {
      say(count, why, remedy);
    }
    else
    {
      skipped += count;
    }
  };
  say(counts[POSITION], "their position is not finite",
    "Make an array of inputs[0].Points with Python Calculator, and remove these points with Threshold.");
  const double factor = std::abs(settings.ScaleFactor);
  const bool usable = factor >= std::numeric_limits<float>::min() && factor <= std::numeric_limits<float>::max();
  if (!settings.Scaling || !usable)
  {
    say(counts[SCALE] + counts[ZERO_SCALE],
      "ScaleFactor, or Scale of the representation, is zero, not finite, or too large or small for floats",
      "Set it to a number from 1e-38 to 1e38.");
  }
  else
  {
    const std::string scale = "their scale, from the point array '" + settings.ScaleArray + "', is ";
    const std::string remedy =
      "Choose another SelectScaleArray, set ScaleMode to No Data Scaling Off, or remove these points with Threshold.";
    say(counts[SCALE], scale + "not finite", remedy);
    sayOfZeros(counts[ZERO_SCALE], scale + "zero", remedy);
  }
  const std::string radius = "their radius, from the point array '" + settings.RadiusArray + "', is ";
  const std::string width = "Choose another GlyphRadiusArray, or None, or remove these points with Threshold.";
  say(counts[RADIUS], radius + "not finite", width);
  sayOfZeros(counts[ZERO_RADIUS], radius + "zero", width);
  const std::string orientation = "their orientation, from the point array '" + settings.OrientationArray + "', is ";
  const std::string turn =
    "Choose another SelectOrientationVectors, switch Orient off, or remove these points with Threshold.";
  say(counts[ORIENTATION], orientation + "not finite", turn);
  sayOfZeros(counts[ZERO_ORIENTATION], orientation + "zero", turn);
  const std::string tensor = "their tensor, from the point array '" + settings.Tensors.Array + "', is ";
  say(counts[TENSOR], tensor + "not finite", "To silence this warning remove the points with Threshold.");
  say(counts[COVARIANCE], tensor + "no covariance, because it has a negative eigenvalue",
    "Choose another GlyphTensorArray or GlyphTensorLayout, or remove these points with Threshold.");
  std::ostringstream direction;
  direction << "their direction is uncertain by 75 degrees or more at GlyphConfidence " << settings.Tensors.Confidence;
  say(counts[DIRECTION], direction.str(), "Choose a lower GlyphConfidence, or GlyphShape Uncertain Vector.");
  sayOfZeros(counts[ZERO_TENSOR], tensor + "zero", "Choose another GlyphTensorArray, or another time step.");
  const std::string components = "the components of their tuple in the point array '" + settings.Forms.Array + "' are ";
  say(counts[POLYNOMIAL], components + "not all finite, or too large or small for floats",
    "To silence this warning remove the points with Threshold.");
  sayOfZeros(counts[ZERO_POLYNOMIAL], components + "all zero", "Choose another array, or another time step.");
  say(counts[MOTION],
    "their velocity, acceleration or angular velocity, or their path while the shutter is "
    "open, is not finite",
    "Choose other arrays, switch MotionBlur off, or remove these points with Threshold.");
  say(counts[FORM], "the index of their mesh, from the point array '" + settings.TableIndexArray + "', is not finite",
    "Choose another GlyphTableIndexArray, or remove these points with Threshold.");
  if (rtglyphs::RayTracedArrays::IsNone(settings.ExponentArray))
  {
    std::ostringstream why;
    why << "GlyphExponents are " << settings.Exponents[0] << ", " << settings.Exponents[1] << ", "
        << settings.Exponents[2];
    say(counts[EXPONENT], why.str(), "Make each of them positive; 2 2 2 is an ellipsoid.");
  }
  else
  {
    say(counts[EXPONENT],
      "their exponents, from the point array '" + settings.ExponentArray + "', are zero, negative or not finite",
      "Choose another GlyphExponentArray, or None, or remove these points with Threshold.");
  }
  return skipped;
}
