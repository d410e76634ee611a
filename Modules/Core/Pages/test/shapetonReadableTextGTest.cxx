#include "shapetonReadableText.h"
#include "shapetonCsvTable.h"

#include "gtest/gtest.h"

#include <cmath>

namespace
{
using shapeton::PlainNumber;
using shapeton::ReadableText;

TEST(PlainNumber, MovesTheDecimalPoint)
{
  EXPECT_EQ(PlainNumber("2.322e+04"), "23220");
  EXPECT_EQ(PlainNumber("-1.526e-05"), "-0.00001526");
  EXPECT_EQ(PlainNumber("1e+00"), "1");
  EXPECT_EQ(PlainNumber("1.25e+01"), "12.5");
  EXPECT_EQ(PlainNumber("12.5"), "12.5");
  EXPECT_EQ(PlainNumber("1.559e-06"), "0.000001559");
  EXPECT_EQ(PlainNumber("1.559e-07"), "1.559 \u00D7 10\u207B\u2077");
  EXPECT_EQ(PlainNumber("4.469e-26"), "4.469 \u00D7 10\u207B\u00B2\u2076");
  EXPECT_EQ(PlainNumber("1e+300"), "1 \u00D7 10\u00B3\u2070\u2070");
}

TEST(PlainNumber, IsTheSameNumber)
{
  for (const double value : { 1.0, 1.0 / 3.0, 23220.0, 1.52587890625e-05, 123456789.0, -0.00071 })
  {
    for (int exponent = -1; exponent <= 6; ++exponent) // not grouped after the decimal point
    {
      const double      scaled = value * std::pow(10.0, exponent);
      const std::string plain = PlainNumber(shapeton::CsvTable::Number(scaled));
      EXPECT_EQ(plain.find('e'), std::string::npos) << plain;
      EXPECT_EQ(std::stod(plain), scaled) << plain;
    }
  }
}

TEST(PlainNumber, LeavesOtherTexts)
{
  for (const std::string text : { "", "nan", "-inf", "e+04", "12e4567890", "1e", "7 mm", "007", "1.2.3", "p7" })
  {
    EXPECT_EQ(PlainNumber(text), text);
  }
}

TEST(Quantity, IsANumberWithOrWithoutAUnit)
{
  const auto isQuantity = [](const std::string & text, const std::string & number, const std::string & unit) {
    const auto quantity = shapeton::QuantityOf(text);
    return quantity && quantity->number == number && quantity->unit == unit;
  };
  EXPECT_TRUE(isQuantity("-31.5", "-31.5", ""));
  EXPECT_TRUE(isQuantity("2322 mm", "2322", "mm"));
  EXPECT_TRUE(isQuantity("281 cm^2", "281", "cm^2"));
  EXPECT_TRUE(isQuantity("100 %", "100", "%"));
  EXPECT_TRUE(isQuantity("1 246 908", "1246908", ""));
  for (const std::string text : { "", "mm", "3 of 4", "1, 5 mm", "0.1.0", "12 34", "5 mmHg", "5 mm off", "007", "3rd" })
  {
    EXPECT_FALSE(shapeton::QuantityOf(text)) << text;
  }
}

TEST(Quantity, SeparatesThousands)
{
  EXPECT_EQ(shapeton::ReadableQuantity({ "999", "" }), "999");
  EXPECT_EQ(shapeton::ReadableQuantity({ "2322", "mm" }), "2\u202F322 mm");
  EXPECT_EQ(shapeton::ReadableQuantity({ "-1234567.125", "" }), "-1\u202F234\u202F567.125");
  EXPECT_EQ(shapeton::ReadableQuantity({ "2.322e+04", "mm^2" }), "23\u202F220 mm\u00B2");
}

TEST(ReadableText, ChangesNumbersAlone)
{
  EXPECT_EQ(ReadableText("an area of 2.322e+04 mm^2 (1e-05 of it), then 1.5e+03."),
            "an area of 23\u202F220 mm\u00B2 (0.00001 of it), then 1500.");
  EXPECT_EQ(ReadableText("from 1327 mm to 55000"), "from 1\u202F327 mm to 55000");
  EXPECT_EQ(ReadableText("2.322e+04"), "23220");
  for (const std::string text : { "sha256:8c53e+04",
                                  "1234567e-8901-4c12-83ee-0123456789ab",
                                  "a/1e+04/b",
                                  "1e+04.nrrd",
                                  "1.2.840.10008",
                                  "at 12:30, 20240105",
                                  "heat-000000100.nrrd",
                                  "x1e+04",
                                  "-",
                                  "\xC3\xA4 1.",
                                  "" })
  {
    EXPECT_EQ(ReadableText(text), text);
  }
}
} // namespace
