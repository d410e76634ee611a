#include "shapetonColonLandmarkDocument.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(ColonLandmarkDocument, FlexuresThatWereNotFoundAreUnknown)
{
  const shapeton::Json document = shapeton::Json::parse(R"({ "flexures": [
    { "number": 1, "found": true, "arcLength": 181.5, "confidence": 0.75 },
    { "number": 3, "found": true, "arcLength": 700, "confidence": 1 },
    { "number": 4, "found": false, "reason": "too short" } ] })");
  const auto           flexures = shapeton::FlexuresOf(document);
  EXPECT_EQ(flexures[0].arcLength, 181.5);
  EXPECT_EQ(flexures[0].confidence, 0.75);
  EXPECT_EQ(flexures[2].arcLength, 700.0);
  for (const int unknown : { 1, 3 })
  {
    EXPECT_TRUE(std::isnan(flexures[unknown].arcLength));
    EXPECT_EQ(flexures[unknown].confidence, 0.0);
  }
}

TEST(ColonLandmarkDocument, AnotherDocumentIsRefused)
{
  EXPECT_THROW(shapeton::FlexuresOf(shapeton::Json::parse("{}")), shapeton::InputError);
  EXPECT_THROW(shapeton::FlexuresOf(shapeton::Json::parse(R"({ "flexures": [ { "number": "one" } ] })")),
               shapeton::InputError);
}
