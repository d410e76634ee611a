#include "GraphEmbeddingVerifierXML.h"

#include "shapetonCommandLine.h"
#include "shapetonEmbeddingVerification.h"
#include "shapetonJson.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"

#include <iostream>

namespace
{
using namespace shapeton;

void
WriteStatistics(CommandLine & commandLine, const EmbeddingVerdict & verdict)
{
  Json document;
  document["provenance"] = ProvenanceToJson(commandLine.GetProvenance());
  document["valid"] = verdict.refusal.empty();
  document["refusal"] = verdict.refusal;
  document["measures"] = Json::object();
  for (const auto & [name, value] : verdict.measures)
  {
    document["measures"][name] = value;
  }
  WriteJson(document, commandLine.OutputOf("statistics"));
  commandLine.Publish(commandLine.GetString("statistics")); // also for a rejected certificate
}

void
Verify(CommandLine & commandLine)
{
  const std::string          path = commandLine.GetString("certificate");
  const EmbeddingCertificate certificate = ReadEmbeddingCertificate(path);
  const EmbeddingVerdict     verdict = VerifyEmbedding(certificate);
  if (commandLine.IsGiven("statistics"))
  {
    commandLine.AddInput("certificate", "sha256:" + Sha256OfFile(path));
    WriteStatistics(commandLine, verdict);
  }
  if (!verdict.refusal.empty())
  {
    throw InputError('"' + path + "\" does not prove an embedding: " + verdict.refusal +
                     "; compute the certificate again");
  }
  std::cout << "valid";
  for (const auto & [name, value] : verdict.measures)
  {
    std::cout << ", " << name << ' ' << value;
  }
  std::cout << '\n';
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Verify);
}
