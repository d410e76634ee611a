#include "Conversions.h"
#include "shapetonDicomFields.h"
#include "Timer.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

namespace shapeton::python
{
namespace
{
/** Reads an attribute of a Python object as a C++ value. */
template <typename TValue>
TValue
Get(const py::handle & object, const char * attribute)
{
  return object.attr(attribute).cast<TValue>();
}

/** Uses the buffer of a numpy array as the pixels of an image and keeps the array alive. */
template <typename TPixel>
class ArrayContainer : public itk::ImportImageContainer<itk::SizeValueType, TPixel>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ArrayContainer);
  using Self = ArrayContainer;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

  void
  SetArray(const py::array & array)
  {
    m_Array = Share(array);
    // The image is only read, so read-only arrays are also accepted.
    this->SetImportPointer(static_cast<TPixel *>(const_cast<void *>(array.data())), array.size(), false);
  }

protected:
  ArrayContainer() = default;
  ~ArrayContainer() override = default;

private:
  std::shared_ptr<PyObject> m_Array;
};

/** Numbers beyond the range of float32 become infinite without a warning; RequireFinite() refuses them. */
class QuietOverflow
{
public:
  QuietOverflow() : m_State(ClassOf("numpy", "errstate")(py::arg("over") = "ignore")) { m_State.attr("__enter__")(); }
  ~QuietOverflow() { m_State.attr("__exit__")(py::none(), py::none(), py::none()); }

private:
  py::object m_State;
};

/** The array itself if type and layout agree, otherwise a copy. */
template <typename TPixel>
py::array
PixelsOf(const py::array & array)
{
  constexpr int       flags = py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
  const QuietOverflow quiet;
  const py::array_t<TPixel, flags> pixels(array);    // throws MemoryError
  constexpr py::ssize_t            exactInFloat = 2; // bytes of integers
  const bool                       isWideInteger =
    (array.dtype().kind() == 'i' || array.dtype().kind() == 'u') && array.itemsize() > exactInFloat;
  // Integers are compared as such: in float64, numbers beyond 2^53 are rounded.
  const py::object back = isWideInteger ? pixels.attr("astype")(array.dtype()) : py::object(pixels);
  if ((std::is_integral_v<TPixel> || isWideInteger) && !array.dtype().is(pixels.dtype()) &&
      !ClassOf("numpy", "array_equal")(back, array).template cast<bool>())
  {
    constexpr bool isOfVisits = sizeof(TPixel) == sizeof(std::uint32_t);
    throw InputError("the image of " + std::string(py::str(array.dtype())) + " contains values not representable in " +
                     std::string(py::str(pixels.dtype())) + "; " +
                     (!std::is_integral_v<TPixel> ? "subtract an offset or round it: float32 has 24 bits"
                      : isOfVisits                ? "visits are whole numbers; for heat, use classify_heat()"
                                                  : "convert it, for example a mask by array != 0"));
  }
  return pixels;
}

template <typename TPixel>
void
RequireFinite(const TPixel * pixels, const std::array<std::size_t, 3> & shape, const py::array & given)
{
  const std::size_t number = shape[0] * shape[1] * shape[2];
  for (std::size_t i = 0; i < number; ++i)
  {
    if (!std::isfinite(pixels[i]))
    {
      const std::size_t row = i / shape[2];
      const auto        place = py::make_tuple(row / shape[1], row % shape[1], i % shape[2]);
      const bool        isBeyond = std::isfinite(given[place].cast<double>());
      throw InputError("the image contains values that are " +
                       std::string(isBeyond ? "beyond the range of float32" : "not finite (NaN or infinity)") +
                       ", the first at [z, y, x] = " + std::string(py::str(py::list(place))) + "; replace them");
    }
  }
}

py::array
ArrayOfValues(const SurfaceArray & array, const py::handle & owner)
{
  const auto               rows = static_cast<py::ssize_t>(array.values.rows());
  const auto               columns = static_cast<py::ssize_t>(array.values.cols());
  std::vector<py::ssize_t> shape{ rows };
  if (columns != 1)
  {
    shape.push_back(columns);
  }
  const py::array values = py::array_t<double>(shape, array.values.data(), owner);
  return array.areIntegers ? py::array(values.attr("astype")("int32")) : values;
}

py::dict
DictOf(const std::vector<SurfaceArray> & arrays, const py::handle & owner)
{
  py::dict dictionary;
  for (const SurfaceArray & array : arrays)
  {
    dictionary[py::str(array.name)] = ArrayOfValues(array, owner);
  }
  return dictionary;
}

std::vector<SurfaceArray>
ArraysOf(const py::handle & dictionary)
{
  std::vector<SurfaceArray> arrays;
  for (const auto & [name, object] : py::reinterpret_borrow<py::dict>(dictionary))
  {
    SurfaceArray array;
    const auto   values = py::array::ensure(object);
    const char   kind = values ? values.dtype().kind() : 'O';
    array.name = name.cast<std::string>();
    array.areIntegers = kind == 'i' || kind == 'u' || kind == 'b';
    RequireParameter((array.areIntegers || kind == 'f') && (values.ndim() == 1 || values.ndim() == 2),
                     "the array \"" + array.name + "\" must have one row of real numbers per element");
    array.values = values.cast<SurfaceArray::ValueMatrix>();
    RequireParameter(!array.areIntegers || array.values.size() == 0 ||
                       array.values.cwiseAbs().maxCoeff() <= std::numeric_limits<std::int32_t>::max(),
                     "the array \"" + array.name + "\" contains an integer beyond 2^31 - 1; convert it to float64");
    arrays.push_back(std::move(array));
  }
  return arrays;
}

/** A view of a matrix with three columns. */
template <typename TMatrix>
py::array
RowsOfMatrix(const TMatrix & matrix, const py::handle & owner)
{
  return py::array_t<typename TMatrix::Scalar>(
    { static_cast<py::ssize_t>(matrix.rows()), py::ssize_t{ 3 } }, matrix.data(), owner);
}

template <typename TGeometry>
void
ReadShared(const py::handle & object, TGeometry & geometry)
{
  geometry.V = Get<VertexMatrix>(object, "vertices");
  geometry.pointArrays = ArraysOf(object.attr("point_arrays"));
  geometry.cellArrays = ArraysOf(object.attr("cell_arrays"));
  geometry.fieldArrays = ArraysOf(object.attr("field_arrays"));
  geometry.facts = Get<std::vector<std::pair<std::string, std::string>>>(object, "facts");
}

template <typename TGeometry>
py::object
Construct(const char * name, const TGeometry & geometry, const py::object & elements, const py::handle & owner)
{
  return ClassOf("shapeton.mesh", name)(RowsOfMatrix(geometry.V, owner),
                                        elements,
                                        DictOf(geometry.pointArrays, owner),
                                        DictOf(geometry.cellArrays, owner),
                                        DictOf(geometry.fieldArrays, owner),
                                        geometry.facts);
}

std::atomic<std::chrono::milliseconds> progressPeriod{ std::chrono::milliseconds(100) };
} // namespace

py::object
ClassOf(const char * module, const char * name)
{
  return py::module_::import(module).attr(name);
}

/** Sets the DICOM fields of an image from its facts. */
void
SetDicomFields(const py::dict & facts, itk::MetaDataDictionary & dictionary)
{
  for (const auto & [fact, field] : { std::pair("modality", DicomModality),
                                      std::pair("patient_position", DicomPatientPosition),
                                      std::pair("slice_thickness", DicomSliceThickness) })
  {
    if (facts.contains(fact))
    {
      itk::EncapsulateMetaData<std::string>(dictionary, field, py::str(facts[fact]));
    }
  }
}

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
ImageOf(const py::handle & image)
{
  using ImageType = itk::Image<TPixel, 3>;
  const auto                       given = Get<py::array>(image, "array");
  const py::array                  pixels = PixelsOf<TPixel>(given);
  const std::array<std::size_t, 3> shape{ static_cast<std::size_t>(pixels.shape(0)),
                                          static_cast<std::size_t>(pixels.shape(1)),
                                          static_cast<std::size_t>(pixels.shape(2)) };
  if constexpr (std::is_floating_point_v<TPixel>)
  {
    RequireFinite(static_cast<const TPixel *>(pixels.data()), shape, given);
  }
  const auto result = ImageType::New();
  result->SetRegions(typename ImageType::SizeType{ { shape[2], shape[1], shape[0] } });
  result->SetSpacing(Get<std::array<double, 3>>(image, "spacing").data());
  result->SetOrigin(Get<std::array<double, 3>>(image, "origin").data());
  const auto                        direction = Get<std::array<std::array<double, 3>, 3>>(image, "direction");
  typename ImageType::DirectionType matrix;
  for (unsigned int i = 0; i < 9; ++i)
  {
    matrix(i / 3, i % 3) = direction[i / 3][i % 3];
  }
  result->SetDirection(matrix);
  const auto container = ArrayContainer<TPixel>::New();
  container->SetArray(pixels);
  result->SetPixelContainer(container);
  SetDicomFields(Get<py::dict>(image, "facts"), result->GetMetaDataDictionary());
  return result;
}

template <typename TPixel>
py::object
ToPython(const itk::Image<TPixel, 3> * image)
{
  if (!image)
  {
    return py::none();
  }
  const auto          size = image->GetBufferedRegion().GetSize();
  const auto &        axes = image->GetDirection();
  py::array_t<double> direction({ 3, 3 });
  for (int i = 0; i < 9; ++i)
  {
    direction.mutable_at(i / 3, i % 3) = axes(i / 3, i % 3);
  }
  const py::array_t<TPixel> array({ size[2], size[1], size[0] },
                                  image->GetBufferPointer(),
                                  OwnerOf(itk::SmartPointer<const itk::Image<TPixel, 3>>(image)));
  const auto &              spacing = image->GetSpacing();
  const auto &              origin = image->GetOrigin();
  return ClassOf("shapeton.image", "Image")(array,
                                            py::make_tuple(spacing[0], spacing[1], spacing[2]),
                                            py::make_tuple(origin[0], origin[1], origin[2]),
                                            direction);
}

#define INSTANTIATE(type)                                                                                              \
  template itk::Image<type, 3>::Pointer ImageOf<type>(const py::handle &);                                             \
  template py::object                   ToPython<type>(const itk::Image<type, 3> *)
INSTANTIATE(float);
INSTANTIATE(short);
INSTANTIATE(unsigned char);
INSTANTIATE(unsigned short);
INSTANTIATE(unsigned int);
#undef INSTANTIATE

SurfaceMesh
MeshOf(const py::handle & mesh)
{
  SurfaceMesh result;
  ReadShared(mesh, result);
  result.F = Get<FaceMatrix>(mesh, "faces");
  RequireSound(result, "the mesh");
  return result;
}

py::object
ToPython(const SurfaceMesh & mesh, const py::handle & owner)
{
  return Construct("Mesh", mesh, RowsOfMatrix(mesh.F, owner), owner);
}

CurveSet
CurvesOf(const py::handle & curves)
{
  if (py::isinstance<py::array>(curves))
  {
    return CurvesOf(ClassOf("shapeton.mesh", "Curves")(curves));
  }
  CurveSet result;
  ReadShared(curves, result);
  result.curves = Get<std::vector<std::vector<int>>>(curves, "curves");
  RequireSound(result, "the curves");
  return result;
}

py::object
ToPython(const CurveSet & curves, const py::handle & owner)
{
  py::list lists;
  for (const std::vector<int> & curve : curves.curves)
  {
    lists.append(py::array_t<int>(static_cast<py::ssize_t>(curve.size()), curve.data(), owner));
  }
  return Construct("Curves", curves, lists, owner);
}

void
SetProgressPeriod(unsigned int milliseconds)
{
  progressPeriod = std::chrono::milliseconds(milliseconds);
}

/** \class Watch
 * \brief Calls the Python function of Reports when it is due. */
class Watch
{
public:
  explicit Watch(const py::object & function) : m_Function(Share(function)) {}

  /** Receives the progress of the library. Only Complete() reports 1, because a step that reports 1 may not be the
   * last. */
  void
  Report(const std::string & stage, double share)
  {
    constexpr double rounding = 1e-9; // of nested parts
    m_Stage = stage;
    if (share < 1.0 - rounding && m_Timer.IsOver())
    {
      this->Call(share);
    }
  }

  void
  Complete() const
  {
    this->Call(1.0);
  }

private:
  void
  Call(double share) const
  {
    const WithGil                 gil;
    const py::handle              function = m_Function.get();
    py::detail::make_caster<bool> answer; // also accepts numpy.bool_
    if (answer.load(function(share, m_Stage), false) && !static_cast<bool>(answer))
    {
      PyErr_SetString(ClassOf("shapeton._shapeton", "Aborted").ptr(), "the progress function returned False");
      throw py::error_already_set();
    }
  }

  std::shared_ptr<PyObject> m_Function;
  std::string               m_Stage{ "done" };
  Timer                     m_Timer{ progressPeriod.load() };
};

Reports::Reports(const py::object & function)
  : Reports(function.is_none() ? nullptr : std::make_shared<Watch>(function))
{}

Reports::Reports(std::shared_ptr<Watch> watch)
  : Progress(watch ? Progress([watch](const std::string & stage, double share) { watch->Report(stage, share); })
                   : Progress())
  , m_Watch(std::move(watch))
{}

void
Reports::Complete() const
{
  if (m_Watch)
  {
    m_Watch->Complete();
  }
}

void
RequireFinitePlace(const double * place, py::ssize_t row)
{
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
  {
    throw InputError("point " + std::to_string(row) + " is not finite (NaN or infinity)");
  }
}

py::array_t<double>
RowsOf(const std::vector<Eigen::Vector3d> & places)
{
  py::array_t<double> rows({ static_cast<py::ssize_t>(places.size()), py::ssize_t{ 3 } });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::copy_n(places[i].data(), 3, rows.mutable_data(static_cast<py::ssize_t>(i), 0));
  }
  return rows;
}

py::dict
FromJson(const Json & document)
{
  return ClassOf("json", "loads")(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}
} // namespace shapeton::python
