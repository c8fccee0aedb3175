#include "RayTracedSuggestion.h"

#include "RayTracedGlyphDefaults.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"

#include <cstring>

namespace
{
// Used while FromData is on, and Switch where there is one, else by glyphs; a second element of Guess is Limit's.
struct Suggested
{
  const char *Number, *FromData, *Guess, *Limit, *Switch;
};
constexpr Suggested suggestions[] = {
  { "ScaleFactor", "ScaleFactorFromData", "ScaleFactorGuess", "GlyphSizeLimit", nullptr },
  { "ShutterTime", "ShutterTimeFromData", "ShutterTimeGuess", nullptr, "MotionBlur" },
};

bool taking = false; // a number is set to what the data suggest, not by the user
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedSuggestion::Follow(vtkSMProxy* representation, const char* name)
{
  // Values of another client come with its FromData.
  if (taking || representation->GetSession()->IsProcessingRemoteNotification())
  {
    return;
  }
  for (const Suggested& suggested : suggestions)
  {
    if (strcmp(name, suggested.Number) == 0 && representation->GetProperty(suggested.FromData)) // none while it is made
    {
      vtkSMPropertyHelper(representation, suggested.FromData).Set(0);
    }
  }
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedSuggestion::IsTaking()
{
  return taking;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedSuggestion::Take(vtkSMProxy* shown)
{
  vtkSMProxy* display = shown->GetTrueParentProxy();
  const bool glyphs = RayTracedGlyphDefaults::ShowsGlyphs(display);
  for (const Suggested& suggested : suggestions)
  {
    vtkSMProperty* guess = shown->GetProperty(suggested.Guess);
    const bool used = suggested.Switch ? vtkSMPropertyHelper(display, suggested.Switch).GetAsInt() != 0 : glyphs;
    if (!used || !vtkSMPropertyHelper(display, suggested.FromData).GetAsInt())
    {
      continue;
    }
    shown->UpdatePropertyInformation(guess);
    const vtkSMPropertyHelper found(guess);
    if (found.GetAsDouble() > 0.0)
    {
      taking = true;
      vtkSMPropertyHelper(display, suggested.Number).Set(found.GetAsDouble());
      if (suggested.Limit)
      {
        vtkSMPropertyHelper(shown, suggested.Limit).Set(found.GetAsDouble(1));
      }
      display->UpdateVTKObjects();
      taking = false;
    }
  }
  if (glyphs)
  {
    vtkSMProperty* found = shown->GetProperty("GlyphDataSizesInfo");
    shown->UpdatePropertyInformation(found);
    shown->GetProperty("GlyphDataSizes")->Copy(found);
    shown->UpdateVTKObjects();
  }
}
