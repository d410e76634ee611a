#include "GraphEmbeddingVerifierXML.h"

#include "itkCommandLine.h"
#include "itkEmbeddingVerification.h"
#include "itkJson.h"
#include "itkSha256.h"
#include "itkExceptions.h"

#include <iostream>

namespace
{
using itk::CommandLine;

void
WriteStatistics(CommandLine & commandLine, const itk::EmbeddingVerdict & verdict)
{
  itk::Json document;
  document["provenance"] = itk::ProvenanceToJson(commandLine.GetProvenance());
  document["valid"] = verdict.refusal.empty();
  document["refusal"] = verdict.refusal;
  document["measures"] = itk::Json::object();
  for (const auto & [name, value] : verdict.measures)
  {
    document["measures"][name] = value;
  }
  itk::WriteJson(document, commandLine.OutputOf("statistics"));
  commandLine.Publish(commandLine.GetString("statistics")); // also of a certificate that is refused
}

void
Verify(CommandLine & commandLine)
{
  const std::string               path = commandLine.GetString("certificate");
  const itk::EmbeddingCertificate certificate = itk::ReadEmbeddingCertificate(path);
  const itk::EmbeddingVerdict     verdict = itk::VerifyEmbedding(certificate);
  if (commandLine.IsGiven("statistics"))
  {
    commandLine.AddInput("certificate", "sha256:" + itk::Sha256OfFile(path));
    WriteStatistics(commandLine, verdict);
  }
  if (!verdict.refusal.empty())
  {
    throw itk::InputError('"' + path + "\" proves no embedding: " + verdict.refusal +
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
