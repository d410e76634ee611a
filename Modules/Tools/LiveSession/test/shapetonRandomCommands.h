#ifndef shapetonRandomCommands_h
#define shapetonRandomCommands_h

#include <random>
#include <string>

namespace basetest
{
/** A command chosen by the generator; some are wrong. */
inline std::string
RandomCommand(std::mt19937 & random)
{
  const auto number = [&](int most) { return std::to_string(random() % most); };
  switch (random() % 16)
  {
    case 0:
      return R"({"do": "pause"})";
    case 1:
      return R"({"do": "resume"})";
    case 2:
      return R"({"do": "step", "steps": )" + number(5) + "}";
    case 3:
      return R"({"do": "speed", "stepsPerSecond": )" + number(2000) + "}";
    case 4:
      return R"({"do": "set", "p": )" + number(60) + R"(, "distance": 0.)" + number(10) + "}";
    case 5:
      return R"({"do": "set", "shapetons": )" + number(3000) + R"(, "seed": )" + number(100) + "}";
    case 6:
      return R"({"do": "set", "placement": "initialHeat", "pathRule": "traversal", "smoothing": )" + number(3) + "}";
    case 7:
      return R"({"do": "start", "region": "balls", "balls": [[)" + number(20) + "," + number(20) + ",20,4]]}";
    case 8:
      return R"({"do": "heat", "timeSteps": )" + number(20000) + "}";
    case 9:
      return R"({"do": "density"})";
    case 10:
      return R"({"do": "save", "name": "r)" + number(3) + R"(", "labels": true, "objects": )" +
             (random() % 2 ? "true" : "false") + (random() % 4 ? "}" : R"(, "selected": true})");
    case 11:
      return random() % 8 ? R"({"do": "objects", "choose": false})" : R"({"do": "objects", "choose": true})";
    case 12:
      return R"({"do": "select", "object": )" + number(3) + "}";
    case 13:
      return R"({"do": "exclude", "region": "balls", "balls": [[)" + number(20) + "," + number(20) + ",20,4]]}";
    case 14:
      return random() % 2 ? R"({"do": "undo"})" : R"({"do": "redo"})";
    default:
      return R"({"do": "start", "region": "everywhere"})";
  }
}

/** A message that a page would not send: not JSON, or of a wrong type. */
inline std::string
RandomMessage(std::mt19937 & random)
{
  std::string   text = RandomCommand(random);
  const auto    at = random() % text.size();
  constexpr int letters = 96; // printable ASCII
  switch (random() % 3)
  {
    case 0:
      return text.substr(0, at);
    case 1:
      text[at] = static_cast<char>(' ' + random() % (letters - 1));
      return text;
    default:
      return std::string(random() % 100000, "[{\"0"[random() % 4]);
  }
}
} // namespace basetest

#endif
