#ifndef FigureProgram_h
#define FigureProgram_h

#include <array>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

/** Calls a body with the arguments of a program for figures; status 2 for a wrong number of them, 1 after an exception.
 * A last argument `--quiet`, which make-figures gives to all tools, is dropped. */
inline int
RunFigureProgram(int                                                   argc,
                 char **                                               argv,
                 const std::array<std::size_t, 2> &                    numberOfArguments,
                 const std::string &                                   usage,
                 const std::function<void(std::vector<std::string>)> & body)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments.back() == "--quiet")
  {
    arguments.pop_back();
  }
  if (arguments.size() < numberOfArguments[0] || arguments.size() > numberOfArguments[1])
  {
    std::cerr << "usage: " << argv[0] << ' ' << usage << '\n';
    return 2;
  }
  try
  {
    body(arguments);
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return EXIT_SUCCESS;
}

#endif
