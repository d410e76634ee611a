#ifndef shapetonMeshArrays_h
#define shapetonMeshArrays_h

#include "shapetonExceptions.h"
#include "shapetonSurfaceMesh.h"

#include "itkDefaultConvertPixelTraits.h"
#include "itkMetaDataObject.h"
#include "itkVariableLengthVector.h"

#include <sstream>

namespace shapeton
{
/** ITK 5.4 and later require this operator for all values of a MetaDataDictionary. \ingroup ShapetonMeshBridge */
inline bool
operator==(const SurfaceArray & left, const SurfaceArray & right)
{
  return left.name == right.name && left.areIntegers == right.areIntegers &&
         left.values.rows() == right.values.rows() && left.values.cols() == right.values.cols() &&
         left.values == right.values;
}

/** Layout of mesh pixels: the concatenated components of one or several arrays. Stored as text in the
 * MetaDataDictionary of the mesh, to restore the names. \ingroup ShapetonMeshBridge */
namespace mesharrays
{
/** Whether pixels may have any number of components. */
template <typename TPixel>
struct IsVariable : std::false_type
{};
template <typename TValue>
struct IsVariable<itk::VariableLengthVector<TValue>> : std::true_type
{};

/** One line for each array: number of components, 1 for integers, name. */
inline std::string
LayoutOf(const std::vector<SurfaceArray> & arrays)
{
  std::ostringstream text;
  for (const SurfaceArray & array : arrays)
  {
    text << array.values.cols() << ' ' << array.areIntegers << ' ' << array.name << '\n';
  }
  return text.str();
}

/** The arrays described by the text, without rows. Empty if their components do not match the pixels, because a
 * filter has replaced the values. */
inline std::vector<SurfaceArray>
ArraysOfLayout(const std::string & layout, Eigen::Index components)
{
  std::vector<SurfaceArray> arrays;
  std::istringstream        lines(layout);
  std::string               line;
  Eigen::Index              sum = 0;
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    Eigen::Index       columns = 0;
    SurfaceArray       array;
    words >> columns >> array.areIntegers;
    std::getline(words.ignore(), array.name);
    array.values.resize(0, columns);
    arrays.push_back(array);
    sum += columns;
  }
  return sum == components ? arrays : std::vector<SurfaceArray>();
}

/** Arrays stored by this pixel type: all of them, or the named one. Throws ParameterError if the named array does not
 * exist or its number of components differs from the pixels'. */
template <typename TPixel>
std::vector<SurfaceArray>
ArraysForPixels(const std::vector<SurfaceArray> & arrays, const std::string & name)
{
  if constexpr (IsVariable<TPixel>::value)
  {
    return arrays;
  }
  else
  {
    if (name.empty())
    {
      return {};
    }
    const SurfaceArray * const array = FindSurfaceArray(arrays, name);
    RequireParameter(array, "the surface has no array \"" + name + '"');
    const auto components = itk::DefaultConvertPixelTraits<TPixel>::GetNumberOfComponents();
    RequireParameter(array->values.cols() == static_cast<Eigen::Index>(components),
                     "the array \"" + name + "\" has " + std::to_string(array->values.cols()) +
                       " components, but the pixels of the mesh have " + std::to_string(components));
    return { *array };
  }
}

/** Pixel of a row. */
template <typename TPixel>
TPixel
PixelOf(const std::vector<SurfaceArray> & arrays, Eigen::Index row)
{
  using Traits = itk::DefaultConvertPixelTraits<TPixel>;
  TPixel pixel{};
  if constexpr (IsVariable<TPixel>::value)
  {
    unsigned int components = 0;
    for (const SurfaceArray & array : arrays)
    {
      components += static_cast<unsigned int>(array.values.cols());
    }
    pixel.SetSize(components);
  }
  int component = 0;
  for (const SurfaceArray & array : arrays)
  {
    for (Eigen::Index column = 0; column < array.values.cols(); ++column)
    {
      const auto value = static_cast<typename Traits::ComponentType>(array.values(row, column));
      Traits::SetNthComponent(component++, pixel, value);
    }
  }
  return pixel;
}

template <typename TPixel>
Eigen::Index
ComponentsOf(const TPixel & pixel)
{
  if constexpr (IsVariable<TPixel>::value)
  {
    return static_cast<Eigen::Index>(pixel.GetSize());
  }
  else
  {
    return static_cast<Eigen::Index>(itk::DefaultConvertPixelTraits<TPixel>::GetNumberOfComponents());
  }
}

/** \class ArrayReader
 * \brief Reads pixels row by row and returns their arrays. \ingroup ShapetonMeshBridge */
template <typename TPixel>
class ArrayReader
{
public:
  /** \param otherwise name of the combined array if the layout does not match. */
  ArrayReader(const std::string & layout, std::string otherwise, Eigen::Index rows)
    : m_Layout(layout), m_Otherwise(std::move(otherwise)), m_Rows(rows)
  {}

  void
  Take(Eigen::Index row, const TPixel & pixel)
  {
    if (m_Values.size() == 0)
    {
      m_Values = SurfaceArray::ValueMatrix::Zero(m_Rows, ComponentsOf(pixel));
    }
    if (m_Values.cols() != ComponentsOf(pixel))
    {
      throw InputError("the pixels of the mesh differ in their number of components");
    }
    for (Eigen::Index c = 0; c < m_Values.cols(); ++c)
    {
      m_Values(row, c) = itk::DefaultConvertPixelTraits<TPixel>::GetNthComponent(static_cast<int>(c), pixel);
    }
  }

  std::vector<SurfaceArray>
  Arrays() const
  {
    std::vector<SurfaceArray> arrays = ArraysOfLayout(m_Layout, m_Values.cols());
    if (arrays.empty() && m_Values.cols() > 0)
    {
      arrays.push_back({ m_Otherwise, m_Values });
      return arrays;
    }
    Eigen::Index begin = 0;
    for (SurfaceArray & array : arrays)
    {
      const Eigen::Index columns = array.values.cols();
      array.values = m_Values.middleCols(begin, columns);
      begin += columns;
    }
    return arrays;
  }

private:
  std::string               m_Layout;
  std::string               m_Otherwise;
  Eigen::Index              m_Rows;
  SurfaceArray::ValueMatrix m_Values;
};
} // namespace mesharrays
} // namespace shapeton

#endif
