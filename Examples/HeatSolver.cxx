// A parallel solver that writes its results to a .gtn file: heat spreads in a box of hexahedra.
// Each process has some layers of it, and writes its own part. Nothing is gathered.
//
//   mpiexec -n 3 HeatSolver heat.gtn             all outputs in one file
//   mpiexec -n 3 HeatSolver heat_%d.gtn          a file for each output, while the solver runs
//   mpiexec -n 3 HeatSolver heat.gtn 200 40 4    200 cubes along each axis, 40 steps, 4 outputs
//
// One file needs each output twice: the writer first looks at the values on the boundaries of the
// parts. So the solver keeps the outputs of its part until it ends. With a file for each output,
// nothing is kept.
#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkGatunWriter.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridAlgorithm.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

// The part of the box that a process has: layers of cubes, and the planes of points around them.
class Heat
{
public:
  Heat(vtkMPIController* controller, int cubes)
    : Controller(controller)
    , N(cubes)
    , Plane(static_cast<std::size_t>(cubes + 1) * (cubes + 1))
  {
    const int rank = controller->GetLocalProcessId();
    const int ranks = controller->GetNumberOfProcesses();
    this->First = cubes * rank / ranks;
    this->Last = cubes * (rank + 1) / ranks;
    // A plane more on each side, which belongs to the neighbor.
    this->Now.resize(this->Plane * (this->Last - this->First + 3));
    for (int z = this->First; z <= this->Last; ++z)
    {
      for (int y = 0; y <= this->N; ++y)
      {
        for (int x = 0; x <= this->N; ++x)
        {
          const double a = x / double(this->N) - 0.3;
          const double b = y / double(this->N) - 0.5;
          const double c = z / double(this->N) - 0.4;
          this->Now[this->At(x, y, z)] = std::exp(-20 * (a * a + b * b + c * c));
        }
      }
    }
  }

  // One explicit step. Heat leaves the box at its sides. Each process computes the planes that it
  // has in common with a neighbor, with the same result.
  void Step()
  {
    this->ExchangePlanes();
    std::vector<double> next = this->Now;
    for (int z = std::max(1, this->First); z <= std::min(this->N - 1, this->Last); ++z)
    {
      for (int y = 1; y < this->N; ++y)
      {
        for (int x = 1; x < this->N; ++x)
        {
          const double here = this->Now[this->At(x, y, z)];
          next[this->At(x, y, z)] = here +
            0.15 *
              ((this->Now[this->At(x - 1, y, z)] + this->Now[this->At(x + 1, y, z)]) +
                (this->Now[this->At(x, y - 1, z)] + this->Now[this->At(x, y + 1, z)]) +
                (this->Now[this->At(x, y, z - 1)] + this->Now[this->At(x, y, z + 1)]) - 6 * here);
        }
      }
    }
    this->Now.swap(next);
  }

  // The mesh of this process. Global ids tell which points of two processes are one. Without them,
  // equal coordinates would.
  vtkSmartPointer<vtkUnstructuredGrid> MakeMesh() const
  {
    auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkTypeInt64Array> ids;
    ids->SetName("id");
    if (this->Last > this->First)
    {
      for (int z = this->First; z <= this->Last; ++z)
      {
        for (int y = 0; y <= this->N; ++y)
        {
          for (int x = 0; x <= this->N; ++x)
          {
            points->InsertNextPoint(x / double(this->N), y / double(this->N), z / double(this->N));
            ids->InsertNextValue((vtkTypeInt64(z) * (this->N + 1) + y) * (this->N + 1) + x);
          }
        }
      }
    }
    mesh->SetPoints(points);
    mesh->GetPointData()->SetGlobalIds(ids);
    vtkNew<vtkCellArray> cells;
    const auto at = [this](int x, int y, int z) -> vtkIdType
    { return (vtkIdType(z) * (this->N + 1) + y) * (this->N + 1) + x; };
    for (int z = 0; z < this->Last - this->First; ++z)
    {
      for (int y = 0; y < this->N; ++y)
      {
        for (int x = 0; x < this->N; ++x)
        {
          cells->InsertNextCell(
            { at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z), at(x, y, z + 1),
              at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1) });
        }
      }
    }
    mesh->SetCells(VTK_HEXAHEDRON, cells);
    return mesh;
  }

  // The temperatures of the points of the mesh.
  vtkSmartPointer<vtkDoubleArray> MakeValues() const
  {
    auto values = vtkSmartPointer<vtkDoubleArray>::New();
    values->SetName("temperature");
    if (this->Last > this->First)
    {
      const auto begin = this->Now.begin() + static_cast<std::ptrdiff_t>(this->Plane);
      const auto size = this->Plane * (this->Last - this->First + 1);
      values->SetNumberOfValues(static_cast<vtkIdType>(size));
      std::copy(begin, begin + static_cast<std::ptrdiff_t>(size), values->GetPointer(0));
    }
    return values;
  }

private:
  std::size_t At(int x, int y, int z) const
  {
    return (z - this->First + 1) * this->Plane + static_cast<std::size_t>(y) * (this->N + 1) + x;
  }

  // Sends the planes next to the common ones to the neighbors.
  void ExchangePlanes()
  {
    const int rank = this->Controller->GetLocalProcessId();
    const int ranks = this->Controller->GetNumberOfProcesses();
    const auto size = static_cast<vtkIdType>(this->Plane);
    const auto up = [&](bool sends)
    {
      if (sends && rank + 1 < ranks)
      {
        this->Controller->Send(&this->Now[this->At(0, 0, this->Last - 1)], size, rank + 1, 1);
      }
      else if (!sends && rank > 0)
      {
        this->Controller->Receive(&this->Now[this->At(0, 0, this->First - 1)], size, rank - 1, 1);
      }
    };
    const auto down = [&](bool sends)
    {
      if (sends && rank > 0)
      {
        this->Controller->Send(&this->Now[this->At(0, 0, this->First + 1)], size, rank - 1, 2);
      }
      else if (!sends && rank + 1 < ranks)
      {
        this->Controller->Receive(&this->Now[this->At(0, 0, this->Last + 1)], size, rank + 1, 2);
      }
    };
    for (const bool sends : { rank % 2 == 0, rank % 2 != 0 }) // no two wait for each other
    {
      up(sends);
      down(sends);
    }
  }

  vtkMPIController* Controller;
  int N;
  std::size_t Plane;
  int First = 0;
  int Last = 0;
  std::vector<double> Now;
};

// Hands the outputs of a solver to the writer, time step by time step.
class HeatSource : public vtkUnstructuredGridAlgorithm
{
public:
  static HeatSource* New();
  vtkTypeMacro(HeatSource, vtkUnstructuredGridAlgorithm);

  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  std::vector<double> Times;
  std::vector<vtkSmartPointer<vtkDoubleArray>> Values;

protected:
  HeatSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    const auto count = static_cast<int>(this->Times.size());
    const double range[] = { this->Times.front(), this->Times.back() };
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), this->Times.data(), count);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    auto* const time = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    const double wanted = info->Has(time) ? info->Get(time) : this->Times.front();
    const auto step = static_cast<std::size_t>(
      std::find(this->Times.begin(), this->Times.end(), wanted) - this->Times.begin());
    if (step == this->Times.size())
    {
      return 0;
    }
    auto* grid = vtkUnstructuredGrid::GetData(output);
    grid->ShallowCopy(this->Mesh);
    grid->GetPointData()->SetScalars(this->Values[step]);
    grid->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), wanted);
    return 1;
  }
};
vtkStandardNewMacro(HeatSource);

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  const std::string name = argc > 1 ? argv[1] : "heat.gtn";
  const int cubes = argc > 2 ? std::atoi(argv[2]) : 24;
  const int steps = argc > 3 ? std::atoi(argv[3]) : 20;
  const int outputs = argc > 4 ? std::atoi(argv[4]) : 5;
  if (cubes < controller->GetNumberOfProcesses() || steps < 1 || outputs < 1 || outputs > steps)
  {
    std::cerr << "HeatSolver: at least a layer of cubes for each process, and a step for each "
                 "output\n";
    controller->Finalize();
    return 2;
  }

  Heat heat(controller, cubes);
  vtkNew<HeatSource> source;
  source->Mesh = heat.MakeMesh();
  vtkNew<vtkGatunWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetController(controller);
  writer->WriteAllTimeStepsOn();

  const auto place = name.find("%d");
  const bool isSeries = place != std::string::npos;
  bool succeeded = true; // in all processes, or in none
  for (int step = 0, written = 0; step < steps && succeeded; ++step)
  {
    heat.Step();
    if ((step + 1) * outputs / steps == written)
    {
      continue;
    }
    source->Times.push_back(0.01 * (step + 1));
    source->Values.push_back(heat.MakeValues());
    source->Modified();
    if (isSeries)
    {
      std::string file = name;
      writer->SetFileName(file.replace(place, 2, std::to_string(written)).c_str());
      succeeded = writer->Write() == 1;
      source->Times.clear();
      source->Values.clear();
    }
    ++written;
  }
  if (!isSeries)
  {
    writer->SetFileName(name.c_str());
    succeeded = writer->Write() == 1;
  }
  if (succeeded && controller->GetLocalProcessId() == 0)
  {
    vtkTable* const statistics = writer->GetStatistics();
    std::cout << statistics->GetValueByName(0, "Points").ToString() << " points, "
              << statistics->GetValueByName(0, "Cells").ToString() << " cells, "
              << statistics->GetValueByName(0, "TimeSteps").ToString() << " steps\n";
  }
  controller->Finalize();
  return succeeded ? 0 : 1;
}
