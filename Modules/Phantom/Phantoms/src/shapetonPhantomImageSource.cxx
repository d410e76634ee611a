#include "shapetonPhantomImageSource.h"

namespace shapeton
{
PhantomImageSource::PhantomImageSource(unsigned int outputs)
{
  this->SetNumberOfRequiredOutputs(outputs);
  for (unsigned int n = 1; n < outputs; ++n)
  {
    this->SetNthOutput(n, this->MakeOutput(n));
  }
}

itk::ProcessObject::DataObjectPointer
PhantomImageSource::MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType output)
{
  if (output > 0)
  {
    return LabelImageType::New().GetPointer();
  }
  return Superclass::MakeOutput(output);
}

void
PhantomImageSource::CenterOutput(const PointType & center)
{
  itk::Vector<double, 3> toCenter;
  for (unsigned int i = 0; i < 3; ++i)
  {
    toCenter[i] = 0.5 * (static_cast<double>(this->GetSize()[i]) - 1.0) * this->GetSpacing()[i];
  }
  this->SetOrigin(center - this->GetDirection() * toCenter);
}

void
PhantomImageSource::GenerateOutputInformation()
{
  for (const auto & data : this->GetIndexedOutputs())
  {
    auto * const output = static_cast<itk::ImageBase<3> *>(data.GetPointer());
    if (this->GetUseReferenceImage() && this->GetReferenceImage())
    {
      output->CopyInformation(this->GetReferenceImage());
      continue;
    }
    output->SetLargestPossibleRegion(OutputImageRegionType(this->GetStartIndex(), this->GetSize()));
    output->SetSpacing(this->GetSpacing());
    output->SetOrigin(this->GetOrigin());
    output->SetDirection(this->GetDirection());
  }
}
} // namespace shapeton
