// VTK (BSD): an edge table and one queue of edges.

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkVersion.h>

#include "tools/bench/peers/peer.h"

namespace aomd::peers {
namespace {

void build(const IndexedMesh& from, vtkPolyData* mesh) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const glm::dvec3& p : from.positions) points->InsertNextPoint(p.x, p.y, p.z);
  for (const auto& [a, b, c] : from.triangles) {
    const vtkIdType corners[3] = {a, b, c};
    cells->InsertNextCell(3, corners);
  }
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
}

IndexedMesh read_back(vtkPolyData* mesh) {
  IndexedMesh result;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
    const double* p = mesh->GetPoint(i);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  vtkIdType n = 0;
  const vtkIdType* v = nullptr;
  vtkCellArray* cells = mesh->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(n, v);)
    result.triangles.push_back({static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                                static_cast<std::uint32_t>(v[2])});
  return result;
}

Simplified quadric(const IndexedMesh& from, std::size_t faces) {
  vtkNew<vtkPolyData> mesh;
  build(from, mesh);
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(mesh);
  decimation->SetTargetReduction(1 - static_cast<double>(faces) /
                                         static_cast<double>(from.triangles.size()));
  Simplified simplified;
  simplified.seconds = seconds_of([&] { decimation->Update(); });
  simplified.mesh = read_back(decimation->GetOutput());
  return simplified;
}

constexpr Method all[] = {{"vtkQuadricDecimation", quadric}};

}  // namespace

std::string library() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }
std::span<const Method> methods() { return all; }

}  // namespace aomd::peers
