#include "RayTracedTree.h"

#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkVersionMacros.h"

#include <map>
#include <set>
#include <vector>

namespace
{
// Those of vtkPVGeometryFilter: multi-block data sets, and since ParaView 5.12 collections of what was none before.
vtkSmartPointer<vtkDataObjectTree> NewTree([[maybe_unused]] vtkCompositeDataSet* input)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (!vtkMultiBlockDataSet::SafeDownCast(input))
  {
    return vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  }
#endif
  return vtkSmartPointer<vtkMultiBlockDataSet>::New();
}

bool HasBranches(vtkCompositeDataSet* input)
{
  return vtkMultiBlockDataSet::SafeDownCast(input) || vtkPartitionedDataSetCollection::SafeDownCast(input);
}

// Ranks may have different numbers of pieces of one block, and of multi-block data sets VTK puts together leaf by leaf.
void MatchPieces(vtkMultiBlockDataSet* tree)
{
  std::vector<vtkMultiPieceDataSet*> blocks;
  for (vtkDataObject* node : vtk::Range(tree, vtk::DataObjectTreeOptions::TraverseSubTree))
  {
    if (auto* pieces = vtkMultiPieceDataSet::SafeDownCast(node))
    {
      blocks.push_back(pieces);
    }
  }
  if (!blocks.empty())
  {
    std::vector<double> most;
    for (vtkMultiPieceDataSet* pieces : blocks)
    {
      most.push_back(pieces->GetNumberOfPieces());
    }
    rtglyphs::RayTracedRanks::Reduce(most, vtkCommunicator::MAX_OP);
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      blocks[i]->SetNumberOfPieces(static_cast<unsigned int>(most[i]));
    }
  }
}

// Field data of one number, which stay where leaves of several ranks are put together.
void AddNumber(vtkPolyData* leaf, const char* name, unsigned int number)
{
  vtkNew<vtkUnsignedIntArray> array;
  array->SetName(name);
  array->InsertNextValue(number);
  leaf->GetFieldData()->AddArray(array);
}

// At the place of the iterator; of levels of an AMR, and of partitions without a collection, the next one.
void SetLeaf(vtkDataObjectTree* tree, vtkCompositeDataIterator* place, unsigned int next, vtkPolyData* leaf)
{
  auto* multiBlock = vtkMultiBlockDataSet::SafeDownCast(tree);
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(tree);
  if (HasBranches(place->GetDataSet()))
  {
    tree->SetDataSet(place, leaf);
  }
  else if (multiBlock)
  {
    multiBlock->SetBlock(next, leaf);
  }
  else if (collection)
  {
    collection->SetPartition(0, next, leaf);
  }
}
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> rtglyphs::RayTracedTree::Make(
  vtkDataObject* input, int distinctColors, const std::function<vtkSmartPointer<vtkPolyData>(vtkDataObject*)>& make)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return make(input);
  }
  const vtkSmartPointer<vtkDataObjectTree> tree = NewTree(composite);
  auto* multiBlock = vtkMultiBlockDataSet::SafeDownCast(tree);
  if (HasBranches(composite))
  {
    tree->CopyStructure(composite);
    if (multiBlock && rtglyphs::RayTracedRanks::Count() > 1)
    {
      MatchPieces(multiBlock);
    }
  }
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  leaf->SetSkipEmptyNodes(false); // an empty block has a number, too
  unsigned int block = 0;
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem(), ++block)
  {
    const vtkSmartPointer<vtkPolyData> made = make(leaf->GetCurrentDataObject());
    AddNumber(made, rtglyphs::RayTracedArrays::CompositeIndex, leaf->GetCurrentFlatIndex());
    AddNumber(made, rtglyphs::RayTracedArrays::BlockColors, block % distinctColors);
    SetLeaf(tree, leaf, block, made);
  }
  return tree;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> rtglyphs::RayTracedTree::Change(
  vtkDataObject* data, const std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData*)>& change)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return change(vtkPolyData::SafeDownCast(data));
  }
  auto changed = vtk::TakeSmartPointer(tree->NewInstance());
  changed->CopyStructure(tree);
  auto leaf = vtk::TakeSmartPointer(tree->NewIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    changed->SetDataSet(leaf, change(vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject())));
  }
  return changed;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedTree::ForEachChild(
  vtkDataObjectTree* tree, const std::string& name, const std::function<void(vtkDataObject*, const std::string&)>& work)
{
  int index = 0;
  for (const auto& child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
  {
    vtkInformation* data = child.HasMetaData() ? child.GetMetaData() : nullptr;
    const char* own = data ? data->Get(vtkCompositeDataSet::NAME()) : nullptr;
    if (child.GetDataObject())
    {
      work(child.GetDataObject(),
        own                                           ? own
          : vtkPartitionedDataSet::SafeDownCast(tree) ? name
                                                      : "block" + std::to_string(index));
    }
    ++index;
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedTree::AddPartialArrays(vtkDataObject* tree)
{
  if (rtglyphs::RayTracedRanks::Count() == 1)
  {
    return;
  }
  std::set<std::string> own;
  for (vtkPolyData* leaf : vtkCompositeDataSet::GetDataSets<vtkPolyData>(tree))
  {
    for (vtkFieldData* data :
      { static_cast<vtkFieldData*>(leaf->GetPointData()), static_cast<vtkFieldData*>(leaf->GetCellData()) })
    {
      for (int i = 0; i < data->GetNumberOfArrays() && leaf->GetNumberOfPoints() > 0; ++i)
      {
        const char* name = data->GetAbstractArray(i)->GetName();
        own.insert(name ? name : "");
      }
    }
  }
  own.erase(std::string());
  std::map<std::string, int> ranks; // that have the array
  int withPoints = 0;
  for (const std::vector<std::string>& names :
    rtglyphs::RayTracedRanks::Gather(std::vector<std::string>(own.begin(), own.end())))
  {
    withPoints += names.empty() ? 0 : 1;
    for (const std::string& name : names)
    {
      ++ranks[name];
    }
  }
  vtkNew<vtkStringArray> partial;
  partial->SetName(rtglyphs::RayTracedArrays::PartialArrays);
  partial->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  for (const auto& [name, number] : ranks)
  {
    if (number < withPoints)
    {
      partial->InsertNextValue(name);
    }
  }
  for (vtkPolyData* leaf : vtkCompositeDataSet::GetDataSets<vtkPolyData>(tree))
  {
    leaf->GetFieldData()->RemoveArray(partial->GetName()); // of the last time
    if (partial->GetNumberOfValues() > 0)
    {
      leaf->GetFieldData()->AddArray(partial);
    }
  }
}

//----------------------------------------------------------------------------
unsigned int rtglyphs::RayTracedTree::FlatIndex(vtkPolyData* leaf)
{
  auto* index = vtkUnsignedIntArray::SafeDownCast(
    leaf->GetFieldData()->GetAbstractArray(rtglyphs::RayTracedArrays::CompositeIndex));
  return index && index->GetNumberOfValues() > 0 ? index->GetValue(0) : 0;
}
