#include "shapetonFoldLabels.h"

#include "shapetonDisjointSets.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace shapeton
{
namespace
{
/** Merges labels that meet across the first and last row into the lowest one. */
DisjointSets<>
JoinAcrossCut(const cv::Mat1i & labels, int number)
{
  DisjointSets      sets(number);
  const int * const first = labels.ptr<int>(0);
  const int * const last = labels.ptr<int>(labels.rows - 1);
  for (int column = 0; column < labels.cols; ++column)
  {
    for (int other = std::max(0, column - 1); other <= std::min(labels.cols - 1, column + 1); ++other)
    {
      if (first[column] != 0 && last[other] != 0)
      {
        sets.Join(first[column], last[other]);
      }
    }
  }
  return sets;
}
} // namespace

std::vector<FoldPixels>
ConnectedFolds(const FoldPicture & picture, const std::vector<char> & mask)
{
  const cv::Mat1b image(
    picture.rows, picture.columns, reinterpret_cast<unsigned char *>(const_cast<char *>(mask.data())));
  cv::Mat1i labels;
  // The numbering may depend on the number of threads; use only the connectivity.
  const int               number = cv::connectedComponents(image, labels, 8, CV_32S);
  DisjointSets            sets = JoinAcrossCut(labels, number);
  std::vector<int>        places(number, -1);
  std::vector<FoldPixels> folds;
  for (int row = 0; row < picture.rows; ++row)
  {
    const int * const line = labels.ptr<int>(row);
    for (int column = 0; column < picture.columns; ++column)
    {
      if (line[column] != 0)
      {
        int & place = places[sets.Find(line[column])];
        if (place < 0)
        {
          place = static_cast<int>(folds.size());
          folds.emplace_back();
        }
        folds[place].push_back({ column, row });
      }
    }
  }
  return folds;
}
} // namespace shapeton
