#include "vtkGlyphBlockAttributes.h"

#include "vtkDataAssembly.h"
#include "vtkFieldData.h"
#include "vtkRayTracedArrays.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <vector>

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::SetAssembly(const char* name)
{
  const std::string assembly = name ? name : "";
  const bool changed = assembly != this->Assembly;
  this->Assembly = assembly;
  return this->Note(changed);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::AddSelector(const char* selector)
{
  return this->Note(selector && this->Selectors.insert(selector).second);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::RemoveAllSelectors()
{
  const bool changed = !this->Selectors.empty();
  this->Selectors.clear();
  return this->Note(changed);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::SetColor(const char* selector, double r, double g, double b)
{
  if (!selector)
  {
    return false;
  }
  const std::array<double, 3> color{ { r, g, b } };
  const auto inserted = this->Colors.insert({ selector, color });
  if (!inserted.second && inserted.first->second == color)
  {
    return false;
  }
  inserted.first->second = color;
  return this->Note(true);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::RemoveAllColors()
{
  const bool changed = !this->Colors.empty();
  this->Colors.clear();
  return this->Note(changed);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::SetOpacity(const char* selector, double opacity)
{
  if (!selector)
  {
    return false;
  }
  const auto inserted = this->Opacities.insert({ selector, opacity });
  if (!inserted.second && inserted.first->second == opacity)
  {
    return false;
  }
  inserted.first->second = opacity;
  return this->Note(true);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::RemoveAllOpacities()
{
  const bool changed = !this->Opacities.empty();
  this->Opacities.clear();
  return this->Note(changed);
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::HasTranslucent() const
{
  return std::any_of(this->Opacities.begin(), this->Opacities.end(),
    [](const auto& item) { return item.second > 0.0 && item.second < 1.0; });
}

//----------------------------------------------------------------------------
std::vector<unsigned int> vtkGlyphBlockAttributes::Hidden(const Table& blocks)
{
  std::vector<unsigned int> hidden;
  for (const auto& [index, block] : blocks)
  {
    if (!block.Visible)
    {
      hidden.push_back(index);
    }
  }
  std::sort(hidden.begin(), hidden.end());
  return hidden;
}

//----------------------------------------------------------------------------
const vtkGlyphBlockAttributes::Table& vtkGlyphBlockAttributes::Resolve(vtkPolyData* points)
{
  const auto timeOf = [points](const char* name)
  {
    vtkAbstractArray* array = points->GetFieldData()->GetAbstractArray(name);
    return array ? array->GetMTime() : 0;
  };
  const std::array<vtkMTimeType, 3> wanted{ timeOf(vtkRayTracedArrays::Hierarchy), timeOf(vtkRayTracedArrays::Leaves),
    this->Version + 1 };
  if (this->KnownFor != wanted)
  {
    this->Known = this->Resolved(points);
    this->KnownFor = wanted;
  }
  return this->Known;
}

//----------------------------------------------------------------------------
bool vtkGlyphBlockAttributes::Note(bool changed)
{
  static std::uint64_t last = 0;
  if (changed)
  {
    this->Version = ++last;
  }
  return changed;
}

//----------------------------------------------------------------------------
vtkGlyphBlockAttributes::Table vtkGlyphBlockAttributes::Resolved(vtkPolyData* points) const
{
  Table table;
  auto* xml = vtkStringArray::SafeDownCast(points->GetFieldData()->GetAbstractArray(vtkRayTracedArrays::Hierarchy));
  auto* leaves =
    vtkUnsignedIntArray::SafeDownCast(points->GetFieldData()->GetAbstractArray(vtkRayTracedArrays::Leaves));
  // The second tree is the data's own assembly, where they have one.
  const vtkIdType tree = xml && xml->GetNumberOfValues() > 1 && this->Assembly == "Assembly" ? 1 : 0;
  vtkNew<vtkDataAssembly> hierarchy;
  if (!xml || !leaves || xml->GetNumberOfValues() < 1 || !hierarchy->InitializeFromXML(xml->GetValue(tree).c_str()))
  {
    return table;
  }

  std::unordered_map<unsigned int, Block> byDataSet;
  const auto select = [&](const std::vector<std::string>& selectors, auto&& apply)
  {
    for (unsigned int index :
      hierarchy->GetDataSetIndices(hierarchy->SelectNodes(selectors), /*traverse_subtree=*/true))
    {
      apply(byDataSet[index]);
    }
  };
  for (vtkIdType i = 0; i < leaves->GetNumberOfTuples(); ++i)
  {
    byDataSet[leaves->GetTypedComponent(i, 1)].Visible = false;
  }
  select({ this->Selectors.begin(), this->Selectors.end() }, [](Block& block) { block.Visible = true; });
  // In the order of the map a node comes before the nodes below it, which may so override it.
  for (const auto& item : this->Colors)
  {
    select({ item.first },
      [&item](Block& block)
      {
        block.HasColor = true;
        block.Color = item.second;
      });
  }
  for (const auto& item : this->Opacities)
  {
    select({ item.first }, [&item](Block& block) { block.Opacity = item.second; });
  }
  for (vtkIdType i = 0; i < leaves->GetNumberOfTuples(); ++i)
  {
    table[leaves->GetTypedComponent(i, 0)] = byDataSet[leaves->GetTypedComponent(i, 1)];
  }
  return table;
}
