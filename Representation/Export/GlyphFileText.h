/**
 * Numbers as text, shortest first: what a long text file of them is written with.
 */
#ifndef GlyphFileText_h
#define GlyphFileText_h

#include <glm/glm.hpp>

#include <charconv>
#include <string>
#include <type_traits>

namespace rtglyphs
{

class GlyphFileText
{
public:
  GlyphFileText& operator<<(const char* text)
  {
    this->Text += text;
    return *this;
  }
  GlyphFileText& operator<<(const std::string& text)
  {
    this->Text += text;
    return *this;
  }
  template <typename Number>
  requires std::is_arithmetic_v<Number> GlyphFileText& operator<<(Number number)
  {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), number).ptr;
    this->Text.append(digits, end);
    return *this;
  }
  template <int Length, typename Number, glm::qualifier Q>
  GlyphFileText& operator<<(const glm::vec<Length, Number, Q>& tuple)
  {
    for (int c = 0; c < Length; ++c)
    {
      *this << (c == 0 ? "(" : ", ") << tuple[c];
    }
    return *this << ")";
  }
  /// Between brackets: what `item` writes of each of so many.
  template <typename Item>
  GlyphFileText& List(std::size_t count, const Item& item)
  {
    *this << "[";
    for (std::size_t k = 0; k < count; ++k)
    {
      *this << (k == 0 ? "" : ", ");
      item(k);
    }
    return *this << "]";
  }

  std::string Text;
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: GlyphFileText.h
