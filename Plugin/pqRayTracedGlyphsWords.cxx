#include "pqRayTracedGlyphsWords.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMRayTracedViewProxy.h"

#include <QObject>

#include <algorithm>
#include <cmath>

//----------------------------------------------------------------------------
QString pqRayTracedGlyphsWords::Of(vtkSMRayTracedViewProxy* scene, bool refined)
{
  const int wanted = vtkSMPropertyHelper(scene, "SamplesPerPixel").GetAsInt();
  const int samples = std::min(scene->GetSamples(), wanted);
  const bool compiling = refined && samples == 0 && scene->GetStep().rfind("Compiling", 0) == 0;
  const bool stopped = !refined && samples < wanted;
  const QString words = compiling
    ? QObject::tr("Compiling")
    : (stopped ? QObject::tr("Stopped at %1 of %2") : QObject::tr("%1 of %2")).arg(samples).arg(wanted);
  const double seconds = !refined ? 0.0 : compiling ? scene->GetSecondsOfStep() : scene->GetSecondsLeft();
  return seconds < 2.0 ? words
    : compiling        ? QObject::tr("%1, %2 s").arg(words).arg(static_cast<int>(seconds))
                       : QObject::tr("%1, about %2 left").arg(words, ForTime(seconds));
}

//----------------------------------------------------------------------------
QString pqRayTracedGlyphsWords::ForTime(double seconds)
{
  // One significant digit is enough and does not flicker.
  const auto rounded = [](double number)
  {
    const double unit = number < 10.0 ? 1.0 : number < 100.0 ? 5.0 : 50.0;
    return static_cast<int>(unit * std::max(1.0, std::round(number / unit)));
  };
  return seconds < 90.0 ? QObject::tr("%1 s").arg(rounded(seconds))
    : seconds < 5400.0  ? QObject::tr("%1 min").arg(rounded(seconds / 60.0))
                        : QObject::tr("%1 h").arg(rounded(seconds / 3600.0));
}
