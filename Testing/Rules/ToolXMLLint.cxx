// ToolXMLLint FILE.xml...: prints the faults of module descriptions; status 1 if there are any.
#include "ToolXMLRules.h"

#include <fstream>
#include <iostream>
#include <iterator>

int
main(int argc, char * argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: ToolXMLLint FILE.xml..." << std::endl;
    return 2;
  }
  rules::Faults faults;
  for (int i = 1; i < argc; ++i)
  {
    std::ifstream stream(argv[i], std::ios::binary);
    if (!stream)
    {
      std::cerr << argv[i] << ": cannot be read" << std::endl;
      return 3;
    }
    const std::string xml{ std::istreambuf_iterator<char>(stream), {} };
    for (rules::Fault & fault : rules::CheckToolXML(xml, argv[i], SHAPETON_VERSION))
    {
      faults.push_back(std::move(fault));
    }
  }
  std::cerr << rules::ToText(faults);
  return faults.empty() ? 0 : 1;
}
