#include "RayTracedSuggestion.h"

#include "DataSummary.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSession.h"

#include <cstring>

namespace
{
struct Suggested
{
  const char *Number, *FromData;
  int Index; // in DataSummary
};
constexpr Suggested suggestions[] = {
  { "ScaleFactor", "ScaleFactorFromData", rtglyphs::DataSummary::SCALE_FACTOR },
  { "ShutterTime", "ShutterTimeFromData", rtglyphs::DataSummary::SHUTTER_TIME },
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
  vtkSMProperty* summary = shown->GetProperty("DataSummary");
  shown->UpdatePropertyInformation(summary);
  taking = true;
  for (const Suggested& suggested : suggestions)
  {
    const double found = vtkSMPropertyHelper(summary).GetAsDouble(suggested.Index);
    if (found > 0.0 && vtkSMPropertyHelper(display, suggested.FromData).GetAsInt())
    {
      vtkSMPropertyHelper(display, suggested.Number).Set(found);
    }
  }
  display->UpdateVTKObjects();
  taking = false;
  shown->GetProperty("DataSummaryOfServer")->Copy(summary);
  shown->UpdateVTKObjects();
}
