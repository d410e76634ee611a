#include "shapetonSurfaceRicciFlow.h"
#include "shapetonPlanarDomains.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRepair.h"
#include <gtest/gtest.h>
#include <chrono>
void Try(const char* name, const shapeton::SurfaceMesh& m, shapeton::SurfaceRicciFlowSettings s={})
{
  auto t0=std::chrono::steady_clock::now();
  try{
  const auto flow = shapeton::FlowSurface(m, s, name);
  double sec=std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count();
  std::printf("%-22s F %d g %d b %d geo %d res %.2g steps %d dfl %d fl %d flipped %d mod %.6f tau %.6f %.6f lay %.2g area %.6f  %.2f s\n", name, m.NumberOfFaces(), flow.genus, flow.boundaries,(int)flow.geometry, flow.residual, flow.steps, flow.delaunayFlips, flow.flips, flow.flippedFaces, flow.modulus, flow.tau.real(), flow.tau.imag(), flow.layoutResidual, flow.area, sec);
  for (auto&w: flow.warnings) std::printf("   %s\n", w.c_str());
  }catch(std::exception&e){std::printf("%-22s FAILED %s\n",name,e.what());}
  std::fflush(stdout);
}
using namespace testsurfaces;
TEST(SurfaceRicciFlow, Explore)
{
  Try("cylinder", Cylinder(24, 20, 1.0, 3.0));
  for (int n: {24,48,96}) Try("annulus", PolarGrid{n,n/4,0.3}.Mesh());
  std::printf("   exact %.6f\n", 2*Pi/std::log(1/0.3));
  for (int n: {1,2,4}) Try("moebius annulus", Moebius(PolarGrid{48*n,12*n,0.3}.Mesh(),0.5));
  for (int n: {16,32,64}) Try("torus", Torus(2*n,n,2.0,1.0));
  std::printf("   exact %.6f or inverse %.6f\n", std::sqrt(3.0), 1/std::sqrt(3.0));
  Try("disk", Square(20,1.0));
  Try("sphere", Icosphere(3,1.0));
  for (double a: {0.05,0.1,0.2,0.3}) Try("rough sphere", Roughened(Icosphere(3,1.0),a,3));
  Try("rough sphere5", Roughened(Icosphere(5,1.0),0.03,3));
  { auto m=Icosphere(4,1.0); for(int i=0;i<m.V.rows();++i){m.V(i,2)*=8;} Try("ellipsoid", m);}
  { auto m=Icosphere(4,1.0); for(int i=0;i<m.V.rows();++i){double z=m.V(i,2); if(z>0.7) m.V(i,2)+=30*(z-0.7);} Try("spike", m);}
  shapeton::SurfaceRicciFlowSettings inv; inv.scheme=shapeton::RicciScheme::InversiveDistance;
  for (int n: {24,48,96}) Try("annulus inv", PolarGrid{n,n/4,0.3}.Mesh(), inv);
  for (int n: {16,32,64}) Try("torus inv", Torus(2*n,n,2.0,1.0), inv);
  const char* dir=getenv("SHAPETON_TEST_DATA_DIR");
  if(!dir) return;
  for (const char* f: {"kitten.obj","elephant.off","fertility.off","hand.off","teapot.obj","punctured-torus.obj","holes.off","face.obj","aorta-surface-open-ends.stl","colon-tube.stl"})
  {
    try{
    shapeton::SurfaceReadOptions o; o.anyExtent=true;
    auto s=shapeton::ReadSurface(std::string(dir)+"/meshes/"+f,o);
    auto m=shapeton::RepairSurface(s.mesh);
    Try(f,m);
    if(std::string(f)!="hand.off") Try("  inversive",m,inv);
    }catch(std::exception&e){std::printf("%s: %s\n",f,e.what());}
  }
}
