// DicomFaultyInputs FOLDER: writes valid and faulty inputs for tool tests.
#include "shapetonDicomFixture.h"

#include <exception>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: DicomFaultyInputs FOLDER\n";
    return 2;
  }
  try
  {
    shapeton::WriteFaultyInputs(argv[1]);
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
