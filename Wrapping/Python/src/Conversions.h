#ifndef Conversions_h
#define Conversions_h

#include "Threads.h"

#include "shapetonCurveSet.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonProgress.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/** Conversions between Python and C++ of images, surfaces, curves and progress. Images are passed both ways without a
 * copy if type and layout agree; surfaces and curves are copied on input and returned as views. */
namespace shapeton::python
{
namespace py = pybind11;
using namespace pybind11::literals;

/** A class of the package, such as "Image" of the module "shapeton.image". Its module is imported once. */
py::object
ClassOf(const char * module, const char * name);

/** The voxels of a shapeton.Image as an ITK image: a view that keeps the array alive if they are C-contiguous and of
 * this type, otherwise a copy. Throws InputError if a voxel is not finite, or not an integer in the range of TPixel. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
ImageOf(const py::handle & image);

/** An ITK image as a shapeton.Image that keeps it alive; nothing is copied. None for a null pointer. */
template <typename TPixel>
py::object
ToPython(const itk::Image<TPixel, 3> * image);

/** A copy of a shapeton.Mesh, validated by RequireSound(). */
SurfaceMesh
MeshOf(const py::handle & mesh);
/** A shapeton.Mesh; its arrays are views of data kept alive by `owner`. */
py::object
ToPython(const SurfaceMesh & mesh, const py::handle & owner);

/** A copy of a shapeton.Curves; for an n x 3 array, one curve through its rows. */
CurveSet
CurvesOf(const py::handle & curves);
/** A shapeton.Curves; its arrays are views of data kept alive by `owner`. */
py::object
ToPython(const CurveSet & curves, const py::handle & owner);

class Watch;

/** \class Reports
 * \brief Progress that calls a Python function, if it is not None, with the completed fraction and the stage.
 *
 * The function is called at most ten times a second, and once with the fraction 1 by Complete(). Aborts if the function
 * returns False (shapeton.Aborted) or throws, and on a signal such as Ctrl-C. Construct it with the GIL held; call it
 * from the same thread without the GIL. */
class Reports : public Progress
{
public:
  Reports() = default;
  explicit Reports(const py::object & function);

  /** Reports completion. */
  void
  Complete() const;

private:
  explicit Reports(std::shared_ptr<Watch> watch);

  std::shared_ptr<Watch> m_Watch; ///< null for None
};

/** Minimum interval between two calls of Reports; 0 for tests, to receive every report. */
void
SetProgressPeriod(unsigned int milliseconds);

template <typename TParameter>
using InReports = std::conditional_t<std::is_same_v<TParameter, const Progress &>, const Reports &, TParameter>;

/** Wraps a function for Python. Its last parameter is `const Progress &`, which receives 1 at the end. */
template <typename TResult, typename... TParameters>
auto
Reporting(TResult (*function)(TParameters...))
{
  return [function](InReports<TParameters>... parameters) -> TResult {
    TResult result = function(std::forward<InReports<TParameters>>(parameters)...);
    std::get<sizeof...(TParameters) - 1>(std::forward_as_tuple(parameters...)).Complete();
    return result;
  };
}

/** Parameter with points in space: finite numbers. */
struct Places
{
  std::vector<Eigen::Vector3d> points;
};

/** Parameter with a file or folder name: a string or a path object. */
struct Path
{
  std::string text;
};

/** An owner for ToPython() that keeps the given Python object alive. */
template <typename TValue>
py::capsule
OwnerOf(TValue && value)
{
  using Value = std::decay_t<TValue>;
  return py::capsule(new Value(std::forward<TValue>(value)), [](void * owned) { delete static_cast<Value *>(owned); });
}

/** Throws InputError unless three numbers are finite; the message contains `row`. */
void
RequireFinitePlace(const double * place, py::ssize_t row);

/** A list of points as n x 3 numbers. */
py::array_t<double>
RowsOf(const std::vector<Eigen::Vector3d> & places);

/** A JSON object as a dictionary. */
py::dict
FromJson(const Json & document);
} // namespace shapeton::python

namespace pybind11::detail
{
template <typename TPixel>
struct type_caster<itk::SmartPointer<itk::Image<TPixel, 3>>>
{
  using Pointer = itk::SmartPointer<itk::Image<TPixel, 3>>;
  PYBIND11_TYPE_CASTER(Pointer, const_name("shapeton.Image"));

  bool
  load(handle source, bool)
  {
    if (!isinstance(source, shapeton::python::ClassOf("shapeton.image", "Image")))
    {
      return false;
    }
    value = shapeton::python::ImageOf<TPixel>(source);
    return true;
  }
  static handle
  cast(const Pointer & image, return_value_policy, handle)
  {
    return shapeton::python::ToPython<TPixel>(image.GetPointer()).release();
  }
};

/** Caster of surfaces and curves: members are views that keep their object alive, results own their data. */
template <typename TGeometry>
struct geometry_caster
{
  static handle
  cast(TGeometry && geometry, return_value_policy, handle)
  {
    auto * const  moved = new TGeometry(std::move(geometry));
    const capsule owner(moved, [](void * owned) { delete static_cast<TGeometry *>(owned); });
    return shapeton::python::ToPython(*moved, owner).release();
  }
  static handle
  cast(const TGeometry & geometry, return_value_policy policy, handle parent)
  {
    if (policy == return_value_policy::reference_internal)
    {
      return shapeton::python::ToPython(geometry, parent).release();
    }
    return cast(TGeometry(geometry), policy, parent);
  }
  static handle
  cast(const TGeometry * geometry, return_value_policy policy, handle parent)
  {
    return cast(*geometry, policy, parent);
  }
};

template <>
struct type_caster<shapeton::SurfaceMesh> : geometry_caster<shapeton::SurfaceMesh>
{
  static constexpr auto name = const_name("shapeton.Mesh");
  template <typename T>
  using cast_op_type = movable_cast_op_type<T>;
  operator shapeton::SurfaceMesh *() { return &value; }
  operator shapeton::SurfaceMesh &() { return value; }
  operator shapeton::SurfaceMesh &&() && { return std::move(value); }

  bool
  load(handle source, bool)
  {
    if (!isinstance(source, shapeton::python::ClassOf("shapeton.mesh", "Mesh")))
    {
      return false;
    }
    value = shapeton::python::MeshOf(source);
    return true;
  }
  using geometry_caster<shapeton::SurfaceMesh>::cast;

private:
  shapeton::SurfaceMesh value;
};

template <>
struct type_caster<shapeton::CurveSet> : geometry_caster<shapeton::CurveSet>
{
  static constexpr auto name = const_name("shapeton.Curves");
  template <typename T>
  using cast_op_type = movable_cast_op_type<T>;
  operator shapeton::CurveSet *() { return &value; }
  operator shapeton::CurveSet &() { return value; }
  operator shapeton::CurveSet &&() && { return std::move(value); }

  bool
  load(handle source, bool)
  {
    if (!isinstance(source, shapeton::python::ClassOf("shapeton.mesh", "Curves")) && !isinstance<array>(source))
    {
      return false;
    }
    value = shapeton::python::CurvesOf(source);
    return true;
  }
  using geometry_caster<shapeton::CurveSet>::cast;

private:
  shapeton::CurveSet value;
};

template <>
struct type_caster<shapeton::python::Reports>
{
  PYBIND11_TYPE_CASTER(shapeton::python::Reports, const_name("Optional[Callable[[float, str], object]]"));

  bool
  load(handle source, bool)
  {
    if (!source.is_none() && PyCallable_Check(source.ptr()) == 0)
    {
      return false;
    }
    value = shapeton::python::Reports(reinterpret_borrow<object>(source));
    return true;
  }
};

template <>
struct type_caster<shapeton::python::Path>
{
  PYBIND11_TYPE_CASTER(shapeton::python::Path, const_name("os.PathLike"));

  bool
  load(handle source, bool)
  {
    const auto path = reinterpret_steal<object>(PyOS_FSPath(source.ptr()));
    if (!path || !isinstance<str>(path))
    {
      PyErr_Clear();
      return false;
    }
    const auto encoded = reinterpret_steal<bytes>(PyUnicode_EncodeFSDefault(path.ptr())); // also of names not in UTF-8
    if (!encoded)
    {
      throw error_already_set();
    }
    value.text = encoded;
    shapeton::RequireParameter(value.text.find('\0') == std::string::npos, "a path contains a null character");
    return true;
  }
  static handle
  cast(const shapeton::python::Path & path, return_value_policy, handle)
  {
    return str(path.text).release();
  }
};

/** Caster of ITK points and vectors: arrays of three numbers. */
template <typename TTriple>
struct triple_caster
{
  PYBIND11_TYPE_CASTER(TTriple, const_name("numpy.ndarray"));

  bool
  load(handle source, bool)
  {
    const auto numbers = array_t<double, array::c_style | array::forcecast>::ensure(source);
    if (!numbers || numbers.ndim() != 1 || numbers.size() != 3)
    {
      PyErr_Clear();
      return false;
    }
    std::copy_n(numbers.data(), 3, value.Begin());
    shapeton::python::RequireFinitePlace(numbers.data(), 0);
    return true;
  }
  static handle
  cast(const TTriple & triple, return_value_policy, handle)
  {
    return array_t<double>(3, triple.Begin()).release();
  }
};

template <>
struct type_caster<itk::Point<double, 3>> : triple_caster<itk::Point<double, 3>>
{};
template <>
struct type_caster<itk::Vector<double, 3>> : triple_caster<itk::Vector<double, 3>>
{};
/** k x 3 numbers, or an empty list. */
template <>
struct type_caster<shapeton::python::Places>
{
  PYBIND11_TYPE_CASTER(shapeton::python::Places, const_name("numpy.ndarray"));

  bool
  load(handle source, bool)
  {
    const auto rows = array_t<double, array::c_style | array::forcecast>::ensure(source);
    if (!rows || (rows.size() > 0 && (rows.ndim() != 2 || rows.shape(1) != 3)))
    {
      PyErr_Clear();
      return false;
    }
    for (ssize_t i = 0; i < rows.size(); i += 3)
    {
      shapeton::python::RequireFinitePlace(rows.data() + i, i / 3);
      value.points.emplace_back(rows.data()[i], rows.data()[i + 1], rows.data()[i + 2]);
    }
    return true;
  }
  static handle
  cast(const shapeton::python::Places & places, return_value_policy, handle)
  {
    return shapeton::python::RowsOf(places.points).release();
  }
};
} // namespace pybind11::detail

#endif
