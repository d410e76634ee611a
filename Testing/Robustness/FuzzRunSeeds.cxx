#include "FuzzRunSeeds.h"

#include "shapetonColonExamination.h"
#include "shapetonColonViewer.h"
#include "shapetonExaminationInputs.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonReaderVerdicts.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonRunRecords.h"

#include "itkImageFileReader.h"
#include "itkImageFileWriter.h"
#include "itkNrrdImageIO.h"
#include "itkVectorImage.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vtkNew.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

namespace
{
using namespace shapeton;
namespace fs = std::filesystem;

void
UnpackSurface(const std::string & path, const std::string & unpacked)
{
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  const vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(unpacked.c_str());
  writer->SetDataModeToAscii();
  writer->Write();
}

template <unsigned int VDimension>
void
UnpackVolume(const std::string & path, const std::string & unpacked)
{
  using ImageType = itk::Image<short, VDimension>;
  const auto reader = itk::ImageFileReader<ImageType>::New();
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->SetFileName(path);
  const auto writer = itk::ImageFileWriter<ImageType>::New();
  writer->SetImageIO(itk::NrrdImageIO::New());
  writer->SetInput(reader->GetOutput());
  writer->SetFileName(unpacked);
  writer->Update();
}

std::string
Unpacked(const std::string & path, bool isFlat, const std::string & folder)
{
  const std::string extension = fs::path(path).extension();
  const std::string unpacked = folder + "/unpacked" + extension;
  if (extension == ".vtp")
  {
    UnpackSurface(path, unpacked);
  }
  else if (extension == ".nrrd")
  {
    isFlat ? UnpackVolume<2>(path, unpacked) : UnpackVolume<3>(path, unpacked);
  }
  else
  {
    return ReadFileBytes(path);
  }
  return ReadFileBytes(unpacked);
}

/** A copy of the run with links to its files, one of which is replaced. */
class RunWithMutant
{
public:
  RunWithMutant(const std::string & mutant, const std::string & exam, const std::string & name)
    : m_Folder(mutant + ".exam")
  {
    fs::create_directory(m_Folder);
    for (const fs::directory_entry & entry : fs::recursive_directory_iterator(exam))
    {
      const fs::path copy = fs::path(m_Folder) / entry.path().lexically_relative(exam);
      if (entry.is_directory())
      {
        fs::create_directory(copy);
      }
      else
      {
        fs::create_symlink(entry.path(), copy);
      }
    }
    fs::remove(m_Folder + '/' + name);
    fs::create_symlink(mutant, m_Folder + '/' + name);
  }
  RunWithMutant(const RunWithMutant &) = delete;
  RunWithMutant &
  operator=(const RunWithMutant &) = delete;
  ~RunWithMutant()
  {
    std::error_code ignored;
    fs::remove_all(m_Folder, ignored);
  }

  const std::string &
  Folder() const
  {
    return m_Folder;
  }

private:
  std::string m_Folder;
};

/** The readers that parse a file, each called as its tool calls it. */
std::vector<std::function<void(const std::string & exam)>>
ReadersOf(const ExaminationFile & file)
{
  std::vector<std::function<void(const std::string & exam)>> readers;
  if (file.IsReadBy("ColonPolyps"))
  {
    readers.emplace_back([](const std::string & exam) { ReadPolypColon(ExaminationFolder(exam)); });
  }
  if (file.IsReadBy("ColonRegistration"))
  {
    readers.emplace_back([](const std::string & exam) { ReadColonPosition(ExaminationFolder(exam), "supine"); });
  }
  if (file.IsReadBy("ColonViewer"))
  {
    readers.emplace_back([](const std::string & exam) {
      ColonViewerOptions options;
      fs::create_directories(exam + "/page/data");
      WriteColonViewer(exam, exam + "/page", options, [](const std::string & path) { return path; });
    });
  }
  readers.emplace_back([](const std::string & exam) { ColonExamination(exam).ReadCandidates(); });
  return readers;
}

const ExaminationFile &
FileAt(const std::string & path)
{
  const auto * const found = std::find_if(std::begin(examination::all),
                                          std::end(examination::all),
                                          [&](const ExaminationFile & file) { return file.Path() == path; });
  if (found == std::end(examination::all))
  {
    throw std::logic_error("no file of an examination: " + path);
  }
  return *found;
}
} // namespace

std::vector<FuzzSeed>
MakeRunSeeds(const std::string & exam, const std::string & folder)
{
  const ExaminationFolder run(exam);
  std::vector<FuzzSeed>   seeds;
  for (const ExaminationFile & file : examination::all)
  {
    const bool isParsed = *file.readers != '\0' && fs::path(file.name).extension() != ".png";
    if (isParsed && run.Has(file) && file.stage != std::string(colonoscopystage::registration))
    {
      std::string name = file.Path();
      std::replace(name.begin(), name.end(), '/', '+');
      const bool isFlat = file.Path() == examination::foldLabels.Path();
      seeds.push_back({ RunExtension + name, Unpacked(run.PathOf(file), isFlat, folder) });
    }
  }
  return seeds;
}

bool
ReadAllOfRun(const std::string & mutant, const std::string & exam)
{
  std::string name = mutant.substr(mutant.find(RunExtension) + std::string(RunExtension).size());
  std::replace(name.begin(), name.end(), '+', '/');
  const ExaminationFile & file = FileAt(name);
  const RunWithMutant     run(mutant, exam, name);
  bool                    isRead = true;
  for (const auto & reader : ReadersOf(file))
  {
    try
    {
      reader(run.Folder());
    }
    catch (const InputError & error)
    {
      isRead = false;
      if (std::string(error.GetDescription()).find(file.name) == std::string::npos)
      {
        throw std::logic_error("the message does not name " + name + ": " + error.GetDescription());
      }
    }
  }
  return isRead;
}
