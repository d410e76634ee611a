#ifndef XMLFaults_h
#define XMLFaults_h

#include "Fault.h"
#include "ToolXMLGrammar.h"
#include "XMLDocument.h"

namespace rules
{
/** Name of a parameter in faults: "<image> input". */
std::string
NameOf(const XMLElement & element);

/** Collects the faults of an XML file and checks single elements. */
class XMLFaults
{
public:
  explicit XMLFaults(std::string file) : m_File(std::move(file)) {}

  void
  Add(int line, const std::string & message)
  {
    m_Faults.push_back({ m_File, line, message });
  }
  const Faults &
  Get() const
  {
    return m_Faults;
  }

  void
  CheckAttributes(const XMLElement & element, const Attributes & allowed);
  /** Checks that there are only known children, each once unless repeatable, and no text between them. */
  void
  CheckChildren(const XMLElement & element, const Names & allowed, const Names & repeatable);
  void
  RequireText(const XMLElement & element, const std::string & child);
  void
  RequireSentence(const XMLElement & element);
  void
  RequireValue(const XMLElement & element, const std::string & child, const std::string & value);

private:
  std::string m_File;
  Faults      m_Faults;
};
} // namespace rules

#endif
