// aomd-peer-vtk-attributes MESH.ply FACES WEIGHT OUT.ply: VTK's quadric decimation with its
// attribute metric, on a PLY with colours as tools/bench/attributes/spheres.py writes it. Colours
// go from 0 to 1, and count with the weight.

#include <cstdio>
#include <cstdlib>

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkUnsignedCharArray.h>

namespace {

template <class To>
vtkNew<To> scaled(vtkDataArray* from, double factor) {
  vtkNew<To> to;
  to->SetName("RGB");
  to->SetNumberOfComponents(3);
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double x = factor * from->GetComponent(i, k);
      to->SetComponent(i, k,
                       factor < 1 ? x
                                  : static_cast<int>(x < 0     ? 0
                                                     : x > 255 ? 255
                                                               : x + 0.5));
    }
  return to;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) {
    std::fputs("usage: aomd-peer-vtk-attributes MESH.ply FACES WEIGHT OUT.ply\n", stderr);
    return 2;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(words[1]);
  reader->Update();
  vtkPolyData* const mesh = reader->GetOutput();
  mesh->GetPointData()->SetScalars(
      scaled<vtkFloatArray>(mesh->GetPointData()->GetArray("RGB"), 1.0 / 255));
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(mesh);
  decimation->SetTargetReduction(1 - std::atof(words[2]) /
                                         static_cast<double>(mesh->GetNumberOfPolys()));
  decimation->SetAttributeErrorMetric(true);
  decimation->SetScalarsAttribute(true);
  decimation->SetScalarsWeight(std::atof(words[3]));
  decimation->Update();
  vtkPolyData* const result = decimation->GetOutput();
  result->GetPointData()->SetScalars(
      scaled<vtkUnsignedCharArray>(result->GetPointData()->GetScalars(), 255));
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(result);
  writer->SetArrayName("RGB");
  writer->SetFileName(words[4]);
  return writer->Write() == 1 ? 0 : 4;
}
