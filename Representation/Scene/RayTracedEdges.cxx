#include "RayTracedEdges.h"

#include "RayTracedRanks.h"
#include "Tracer.h"
#include "vtkCommunicator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// A rank's color and depth in a pixel.
struct Fragment
{
  std::uint32_t Pixel, Color;
  float Depth;
  std::uint32_t Rank;
};

// The color behind it.
struct Behind
{
  std::uint32_t Pixel, Color;
  float Depth;
};

std::uint32_t AlphaOf(std::uint32_t color)
{
  return color >> 24;
}

bool IsEdge(std::uint32_t color)
{
  return AlphaOf(color) > 0 && AlphaOf(color) < 255;
}

template <class Item>
void Append(std::vector<char>& message, const Item& item)
{
  const auto* bytes = reinterpret_cast<const char*>(&item);
  message.insert(message.end(), bytes, bytes + sizeof(item));
}

template <class Item>
std::vector<Item> ItemsOf(const std::vector<char>& bytes)
{
  std::vector<Item> items(bytes.size() / sizeof(Item));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(items.data()));
  return items;
}

// Of the fragments of one pixel, the nearest first. Straight colors in, straight color out.
std::uint32_t Over(const Fragment* first, const Fragment* end)
{
  std::array<double, 3> sum{};
  double clear = 1.0;
  for (const Fragment* at = first; at != end && clear > 0.0; ++at)
  {
    const double share = clear * AlphaOf(at->Color) / 255.0;
    for (int i = 0; i < 3; ++i)
    {
      sum[i] += share * ((at->Color >> (8 * i)) & 255u);
    }
    clear = AlphaOf(at->Color) == 255 ? 0.0 : clear - share;
  }
  std::uint32_t color = static_cast<std::uint32_t>((1.0 - clear) * 255.0 + 0.5) << 24;
  for (int i = 0; i < 3; ++i)
  {
    color |= std::min(static_cast<std::uint32_t>(sum[i] / (1.0 - clear) + 0.5), 255u) << (8 * i);
  }
  return color;
}

// The first pixel of a rank's part of the picture.
std::size_t BeginOf(int rank, int ranks, std::size_t pixels)
{
  return pixels * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks);
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedEdges::Forget()
{
  this->Colors = std::vector<std::uint32_t>(); // = {} would keep the memory
  this->Depths = std::vector<float>();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedEdges::Clear()
{
  this->Forget();
  this->Front = nullptr;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedEdges::Draw(
  const rtg::Image* image, vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  if (image == this->Front && !this->Colors.empty())
  {
    if (!this->Quad.Shows(this->Version))
    {
      this->Quad.SetImage(window, image->width, image->height, this->Colors.data(), this->Depths.data(), this->Version);
    }
    this->Quad.Draw(renderer, actor, mapper, rtglyphs::RayTracedImageQuad::BLEND);
  }
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedEdges::Exchange(const rtg::Image* image, std::uint64_t version)
{
  const bool changed = image != this->Front || (image && version != this->FrontVersion);
  this->Front = image;
  this->FrontVersion = version;

  // Ranks that show nothing have an image of any size.
  const double width = image ? image->width : 0.0, height = image ? image->height : 0.0;
  std::vector<double> largest{ changed ? 1.0 : 0.0, width, image ? -width : -HUGE_VAL, height,
    image ? -height : -HUGE_VAL };
  rtglyphs::RayTracedRanks::Reduce(largest, vtkCommunicator::MAX_OP);
  if (largest[0] == 0.0)
  {
    return std::string();
  }
  this->Forget();
  if (largest[1] == 0.0 || largest[1] != -largest[2] || largest[3] != -largest[4])
  {
    return std::string();
  }
  return rtglyphs::RayTracedRanks::Problem(
    [&] { this->FindBehind(image, static_cast<std::size_t>(largest[1] * largest[3])); });
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedEdges::FindBehind(const rtg::Image* image, std::size_t pixels)
{
  const int ranks = rtglyphs::RayTracedRanks::Count();
  const auto own = static_cast<std::uint32_t>(rtglyphs::RayTracedRanks::Own());
  const std::size_t ownPixels = image ? pixels : 0;

  // Pixels in which any rank shows an edge
  std::vector<unsigned char> edges((pixels + 7) / 8, 0);
  for (std::size_t i = 0; i < ownPixels; ++i)
  {
    edges[i / 8] |= static_cast<unsigned char>(IsEdge(image->color[i]) << (i % 8));
  }
  rtglyphs::RayTracedRanks::Reduce(edges, vtkCommunicator::BITWISE_OR_OP);

  // To the rank that processes the pixel
  std::vector<std::vector<char>> fragments(ranks);
  for (int to = 0; to < ranks && ownPixels > 0; ++to)
  {
    for (std::size_t i = BeginOf(to, ranks, pixels); i < BeginOf(to + 1, ranks, pixels); ++i)
    {
      if (((edges[i / 8] >> (i % 8)) & 1) && AlphaOf(image->color[i]) > 0)
      {
        Append(fragments[to], Fragment{ static_cast<std::uint32_t>(i), image->color[i], image->depth[i], own });
      }
    }
  }
  std::vector<Fragment> all = ItemsOf<Fragment>(rtglyphs::RayTracedRanks::Exchange(std::move(fragments)));

  // To the rank in front, where it shows an edge before another's
  std::vector<std::vector<char>> behind(ranks);
  std::sort(all.begin(), all.end(),
    [](const Fragment& a, const Fragment& b) {
      return a.Pixel != b.Pixel ? a.Pixel < b.Pixel : a.Depth != b.Depth ? a.Depth < b.Depth : a.Rank < b.Rank;
    });
  for (std::size_t first = 0, end = 0; first < all.size(); first = end)
  {
    while (end < all.size() && all[end].Pixel == all[first].Pixel)
    {
      ++end;
    }
    if (end - first > 1 && IsEdge(all[first].Color))
    {
      const Fragment& next = all[first + 1];
      Append(behind[all[first].Rank], Behind{ next.Pixel, Over(&next, all.data() + end), next.Depth });
    }
  }
  const std::vector<Behind> arrived = ItemsOf<Behind>(rtglyphs::RayTracedRanks::Exchange(std::move(behind)));
  if (!arrived.empty())
  {
    std::vector<std::uint32_t> colors(ownPixels, 0);
    std::vector<float> depths(ownPixels, 1.0f);
    for (const Behind& pixel : arrived)
    {
      colors[pixel.Pixel] = pixel.Color;
      depths[pixel.Pixel] = pixel.Depth;
    }
    this->Colors = std::move(colors);
    this->Depths = std::move(depths);
    ++this->Version;
  }
}
