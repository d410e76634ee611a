// Draws a surface in space, plain or colored by a point array from blue over white to red.
// usage: SurfaceColors SURFACE.vtp PICTURE.png [array=NAME,LEAST,GREATEST] [azimuth=DEGREES] [elevation=DEGREES]
//                      [near=X,Y,Z,RADIUS] [curves=CURVES.vtp] [width=MM] [opacity=0..1]
// `near` draws only what is within a radius (mm) of a point; curves are drawn in red.
#include "FigureProgram.h"

#include "shapetonCurveSet.h"
#include "shapetonExceptions.h"
#include "shapetonPicture.h"
#include "shapetonSurfaceMesh.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRendering.h"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

using namespace shapeton;

namespace
{
using Settings = std::map<std::string, std::vector<std::string>>;

Settings
SettingsOf(const std::vector<std::string> & arguments)
{
  Settings settings;
  for (const std::string & argument : arguments)
  {
    const std::size_t  equals = argument.find('=');
    std::istringstream values(argument.substr(equals == std::string::npos ? argument.size() : equals + 1));
    for (std::string value; std::getline(values, value, ',');)
    {
      settings[argument.substr(0, equals)].push_back(value);
    }
  }
  return settings;
}

RGBColor
BlueWhiteRed(double share)
{
  static const RGBColor blue = MakeColor(40, 80, 200);
  static const RGBColor white = MakeColor(240, 240, 235);
  static const RGBColor red = MakeColor(200, 30, 30);
  const double          t = std::clamp(share, 0.0, 1.0);
  return t < 0.5 ? MixColors(blue, white, 2.0 * t) : MixColors(white, red, 2.0 * t - 1.0);
}

std::vector<RGBColor>
ColorsOf(const SurfaceMesh & mesh, const std::vector<std::string> & setting)
{
  const SurfaceArray * const array = FindSurfaceArray(mesh.pointArrays, setting.at(0));
  if (array == nullptr)
  {
    throw InputError("the surface has no point array " + setting[0]);
  }
  const double          least = std::stod(setting.at(1));
  const double          greatest = std::stod(setting.at(2));
  std::vector<RGBColor> colors;
  for (Eigen::Index vertex = 0; vertex < mesh.V.rows(); ++vertex)
  {
    colors.push_back(BlueWhiteRed((array->values(vertex, 0) - least) / (greatest - least)));
  }
  return colors;
}

/** A ball; everything without a setting. */
class Focus
{
public:
  explicit Focus(const std::vector<std::string> & setting)
  {
    if (!setting.empty())
    {
      m_Center = { std::stod(setting.at(0)), std::stod(setting.at(1)), std::stod(setting.at(2)) };
      m_Radius = std::stod(setting.at(3));
    }
  }

  SurfaceMesh
  PartOf(const SurfaceMesh & mesh) const
  {
    std::vector<int> faces;
    for (int face = 0; face < mesh.NumberOfFaces(); ++face)
    {
      if (this->Contains(mesh.V.row(mesh.F(face, 0))))
      {
        faces.push_back(face);
      }
    }
    return FacesOfSurface(mesh, faces);
  }

  CurveSet
  PartOf(const CurveSet & set) const
  {
    CurveSet                     part;
    std::vector<Eigen::Vector3d> points;
    for (const std::vector<int> & curve : set.curves)
    {
      if (!curve.empty() && this->Contains(set.V.row(curve.front())))
      {
        part.curves.emplace_back();
        for (const int vertex : curve)
        {
          part.curves.back().push_back(static_cast<int>(points.size()));
          points.emplace_back(set.V.row(vertex));
        }
      }
    }
    part.V.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      part.V.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    }
    return part;
  }

private:
  bool
  Contains(const Eigen::Vector3d & point) const
  {
    return (point - m_Center).norm() < m_Radius;
  }

  Eigen::Vector3d m_Center{ Eigen::Vector3d::Zero() };
  double          m_Radius{ std::numeric_limits<double>::infinity() };
};

void
Draw(const std::string & surface, const std::string & picture, Settings settings)
{
  SurfaceReadOptions read;
  read.anyExtent = true; // graphs have no unit
  const Focus       focus(settings["near"]);
  const SurfaceMesh mesh = focus.PartOf(ReadSurface(surface, read).mesh);
  SurfaceScene      scene;
  scene.surfaces.push_back({ &mesh });
  if (settings.count("array") != 0)
  {
    scene.surfaces[0].vertexColors = ColorsOf(mesh, settings["array"]);
  }
  const auto numberOf = [&](const char * name, double otherwise) {
    return settings.count(name) != 0 ? std::stod(settings[name].at(0)) : otherwise;
  };
  scene.surfaces[0].opacity = numberOf("opacity", 1.0);
  CurveSet curves;
  if (settings.count("curves") != 0)
  {
    curves = focus.PartOf(ReadCurves(settings["curves"].at(0)));
    scene.curves.push_back({ &curves, numberOf("width", 1.5), MakeColor(200, 30, 30) });
  }
  SurfaceRenderingOptions options;
  options.azimuth = numberOf("azimuth", 0.0);
  options.elevation = numberOf("elevation", 0.0);
  options.annotations = false;
  WritePng(RenderSurfaces(scene, options), picture);
}
} // namespace

int
main(int argc, char * argv[])
{
  return RunFigureProgram(argc,
                          argv,
                          { 2, 99 },
                          "SURFACE.vtp PICTURE.png [NAME=VALUE,...]...",
                          [](const std::vector<std::string> & arguments) {
                            Draw(arguments[0], arguments[1], SettingsOf({ arguments.begin() + 2, arguments.end() }));
                          });
}
