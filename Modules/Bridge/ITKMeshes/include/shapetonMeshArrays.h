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
/** ITK asks this, from 5.4 on, of all that a MetaDataDictionary holds. \ingroup ITKMeshes */
inline bool
operator==(const SurfaceArray & left, const SurfaceArray & right)
{
  return left.name == right.name && left.areIntegers == right.areIntegers &&
         left.values.rows() == right.values.rows() && left.values.cols() == right.values.cols() &&
         left.values == right.values;
}

/** What the pixels of a mesh hold: the components of one or several arrays, one after another. It is kept in the mesh's
 * MetaDataDictionary as text, so that the names come back. \ingroup ITKMeshes */
namespace mesharrays
{
/** Whether pixels may have any number of components. */
template <typename TPixel>
struct IsVariable : std::false_type
{};
template <typename TValue>
struct IsVariable<itk::VariableLengthVector<TValue>> : std::true_type
{};

/** A line for each array: components, 1 for whole numbers, name. */
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

/** The arrays that the text tells, without rows; none where their components are not as many as those of the pixels,
 * because a filter in between has put something else there. */
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

/** Those that pixels of this type hold: all of them, or the one of this name. Throws ParameterError where there is none
 * of this name, or it has another number of components than the pixels. */
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
                       " components, and the pixels of the mesh " + std::to_string(components));
    return { *array };
  }
}

/** The pixel of a row. */
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
 * \brief Takes pixels row by row and gives the arrays that they hold. \ingroup ITKMeshes */
template <typename TPixel>
class ArrayReader
{
public:
  /** \param otherwise the name of all components together where the layout does not suit them. */
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
