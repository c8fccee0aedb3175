#include "GlyphStepVelocity.h"

#include "RayTracedArrays.h"
#include "RayTracedTree.h"
#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::Reset()
{
  this->Now = this->Before = Step();
  this->Outcome = FOUND;
  this->Said = {};
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphStepVelocity::SetPointIdArray(const std::string& name)
{
  if (this->PointIdArray == name)
  {
    return false;
  }
  this->PointIdArray = name;
  this->Reset();
  return true;
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::AddTo(vtkDataObject* gathered, vtkDataObject* input, vtkAlgorithm* source)
{
  if (this->Source != source)
  {
    this->Reset();
    this->Source = source;
  }
  vtkInformation* info = input->GetInformation();
  this->Follow(
    gathered, info->Has(vtkDataObject::DATA_TIME_STEP()) ? info->Get(vtkDataObject::DATA_TIME_STEP()) : vtkMath::Nan());
}

//----------------------------------------------------------------------------
void rtglyphs::GlyphStepVelocity::Follow(vtkDataObject* gathered, double time)
{
  std::vector<vtkFloatArray*> velocities;
  rtglyphs::RayTracedTree::ForEach(gathered,
    [&](vtkPolyData* points)
    {
      vtkNew<vtkFloatArray> ofLeaf;
      ofLeaf->SetName(Name());
      ofLeaf->SetNumberOfComponents(3);
      rtglyphs::RayTracedArrays::Resize(ofLeaf, points->GetNumberOfPoints());
      ofLeaf->FillValue(0.0f);
      points->GetPointData()->AddArray(ofLeaf);
      velocities.push_back(ofLeaf);
    });
  rtglyphs::GlyphStep step(gathered, this->PointIdArray);
  this->Points = step.GetPoints();
  this->WithoutPartner = 0;
  if (step.LacksIds())
  {
    this->Outcome = NO_IDS;
    return;
  }
  if (!std::isfinite(time))
  {
    this->Outcome = NO_TIME;
    return;
  }

  // Data of the same time that come again, as after a change of a filter, take the place of what they were. A step
  // without points counts: those of the next have come from nowhere.
  if (this->Now.Seen && this->Now.Time != time)
  {
    std::swap(this->Before, this->Now);
  }
  this->Now = { true, time, std::move(step) };
  if (!this->Before.Seen)
  {
    this->Outcome = FOUND;
    return;
  }

  const double length = time - this->Before.Time;
  rtglyphs::GlyphStep::Pairs pairs =
    rtglyphs::GlyphStep::Match(this->Now.Points.GetEntries(), this->Before.Points.GetEntries());
  this->WithoutPartner = this->Points - static_cast<vtkIdType>(pairs.size());
  pairs = rtglyphs::GlyphStep::WithoutCrossings(std::move(pairs));
  for (const auto& [now, before] : pairs)
  {
    for (int c = 0; c < 3; ++c)
    {
      velocities[now->Leaf]->SetComponent(now->Point, c, (now->X[c] - before->X[c]) / length);
    }
  }
  this->Outcome = this->WithoutPartner > 0 ? WITHOUT_PARTNER : FOUND;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphStepVelocity::GetStepLength() const
{
  return this->Before.Seen ? std::abs(this->Now.Time - this->Before.Time) : 0.0;
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphStepVelocity::TakeMessage()
{
  bool& said = this->Said[this->Outcome];
  if (said || this->Outcome == FOUND)
  {
    return "";
  }
  said = true;
  return this->Describe();
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphStepVelocity::Describe() const
{
  switch (this->Outcome)
  {
    case NO_IDS:
      return rtglyphs::GlyphStep::IdsNeeded("VelocityFromPreviousStep", "the glyphs stand still");
    case NO_TIME:
      return "VelocityFromPreviousStep needs the time of the data, which they lack; so the glyphs stand still. Open "
             "them as a time series, or choose a VelocityArray.";
    case WITHOUT_PARTNER:
    {
      std::ostringstream text;
      text << this->WithoutPartner << " of " << this->Points
           << " points stand still, because VelocityFromPreviousStep finds no point, or several, with their ids in the "
              "step shown before, at time "
           << this->Before.Time << ". Choose another PointIdArray if they were there. Later steps are not reported.";
      return text.str();
    }
    default:
      return "";
  }
}
