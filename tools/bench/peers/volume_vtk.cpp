// VTK (BSD): vtkUnstructuredGridQuadricDecimation. It knows no regions: their number is the field
// that its quadrics hold on to.

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridQuadricDecimation.h>
#include <vtkVersion.h>

#include "tools/bench/peers/volume_peer.h"

namespace aomd::peers {
namespace {

constexpr const char* field = "region";

// The mean number of the regions around each vertex.
void build(const TetMesh& from, vtkUnstructuredGrid* grid) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : from.positions) points->InsertNextPoint(p.x, p.y, p.z);
  grid->SetPoints(points);
  std::vector<double> sum(from.positions.size(), 0), count(from.positions.size(), 0);
  for (std::size_t i = 0; i < from.tets.size(); ++i) {
    const auto& [a, b, c, d] = from.tets[i];
    const vtkIdType corners[4] = {a, b, c, d};
    grid->InsertNextCell(VTK_TETRA, 4, corners);
    for (const std::uint32_t v : from.tets[i]) sum[v] += from.regions[i], ++count[v];
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName(field);
  for (std::size_t v = 0; v < sum.size(); ++v) values->InsertNextValue(sum[v] / count[v]);
  grid->GetPointData()->SetScalars(values);
}

TetMesh read_back(vtkUnstructuredGrid* grid) {
  TetMesh result;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    const double* p = grid->GetPoint(i);
    result.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    vtkIdType n = 0;
    const vtkIdType* v = nullptr;
    grid->GetCellPoints(i, n, v);
    auto corner = result.tets.emplace_back().begin();
    for (vtkIdType k = 0; k < 4; ++k) *corner++ = static_cast<std::uint32_t>(v[k]);
    result.regions.push_back(1);
  }
  return result;
}

}  // namespace

std::string library() { return std::string("VTK ") + vtkVersion::GetVTKVersion(); }
std::string wants() { return "tets"; }

TetMesh remesh(const TetMesh& mesh, double amount) {
  vtkNew<vtkUnstructuredGrid> grid;
  build(mesh, grid);
  vtkNew<vtkUnstructuredGridQuadricDecimation> decimation;
  decimation->SetInputData(grid);
  decimation->SetScalarsName(field);
  decimation->SetBoundaryWeight(100);
  decimation->SetNumberOfTetsOutput(static_cast<int>(amount));
  decimation->Update();
  return read_back(decimation->GetOutput());
}

}  // namespace aomd::peers
