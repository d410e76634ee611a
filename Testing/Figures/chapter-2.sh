# Chapter 2: cumulative heat diffusion; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 2 'cumulative heat diffusion'

figure 2.3 'equalized and normalized histogram'
needs volumes/ch2.nii.gz
run CumulativeHeatDiffusion ch2.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram equalized.png
run CumulativeHeatDiffusion ch2.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram normalized.png --histogramScale normalized
panels 2 430 "$(histogram equalized.png)=(a) equalized" "$(histogram normalized.png)=(b) normalized"
differs 'Ours: MR head, p = 20, 4,000 steps; the dissertation does not name its data set. **Agrees:** equalization assigns space by' \
  'the number of voxels; without it, the lines of cool parts are crowded at the left.'

figure 2.4 'a cube in time'
run ShapePhantom cube.nrrd --shape figure2.4
run CumulativeHeatDiffusion cube.nrrd cube-heat.nrrd --preset published --timeSteps 4000 --snapshotSteps 20,100,750,900,1000,1100 \
  --snapshotFolder cube-steps --histogram cube-histogram.png
cube=()
for step in 20 100 750 900 1000 1100; do
  run HeatTransferFunction cube.nrrd cube-steps "cube-$step.vp" --timeStep $step --lines 0.026-0.036:orange:0.4,0.036-1:red:0.9 \
    --picture "cube-$step.png"
  cube+=("$(rendering "cube-$step.png")=t = $step")
done
panels 3 280 "${cube[@]}" "$(histogram cube-histogram.png)=4000 steps"
differs 'Ours: 4,000 steps. Orange: within 15 % of the final heat; red: hotter. **Agrees:** faces reach the final heat' \
  'first, then edges, then corners; one line remains. **Not comparable:** the steps depend on the size of the cube' \
  'and the thresholds, which are not printed ([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.6 'one line at a time'
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --preset published --timeSteps 40000 --histogram four-histogram.png
bones=()
for line in 0.0415-0.0445:tomato:1 0.0465-0.0495:yellow:1 0.063-0.068:lime:1 0.07-0.076:skyblue:1; do
  run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --lines $line --picture "four-${line%%:*}.png"
  bones+=("$(rendering "four-${line%%:*}.png")=${line%%:*}")
done
panels 2 330 "${bones[@]}"
differs 'Ours: a phantom of four objects instead of the foot; 40,000 steps. **Agrees:** each line shows its object. Lines' \
  'separate objects by surface over volume; they do not identify them.'

figure 2.7 'scale and orientation'
run ShapePhantom a.nrrd --shape figure2.7a --size 96,96,96
run CumulativeHeatDiffusion a.nrrd a-heat.nrrd --preset published --timeSteps 40000 --histogram a-histogram.png
run HeatTransferFunction a.nrrd a-heat.nrrd a.vp --picture a.png
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --preset published --timeSteps 40000 --histogram four-histogram.png
run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --picture four.png
panels 2 400 "$(rendering a.png)=(a) two spheres, a cube" "$(histogram a-histogram.png)" \
  "$(rendering four.png)=(b) two cubes, two cuboids" "$(histogram four-histogram.png)"
differs 'Ours: 40,000 steps. **Agrees:** three and four lines. **Differs:** the lines of one shape in two sizes are not' \
  'close to each other. The heat values of the spheres differ by a factor of 2, the ratio of their radii; their' \
  '`normalizedHeat` differs by 0.1 % ([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.8 'p'
needs volumes/engine.nii.gz
engine=()
for p in 2 5 10 15; do
  run CumulativeHeatDiffusion engine.nii.gz engine-$p.nrrd --p $p --timeSteps 100
  run HeatTransferFunction engine.nii.gz engine-$p.nrrd engine.vp --lines '0.08-0.2:#3c6bdf:0.15,0.2-1:#dd3d2c:1' \
    --picture engine-$p.png
  engine+=("$(rendering engine-$p.png)=p = $p")
done
panels 2 400 "${engine[@]}"
differs 'Ours: 100 steps; the rendered heat ranges are our choice. **Agrees:** p = 2 and 5 differ much, 10 and 15 little.'

figure 2.9 'an MR head'
needs volumes/ch2.nii.gz
run CumulativeHeatDiffusion ch2.nii.gz head-late.nrrd --p 20 --timeSteps 400000
run HeatTransferFunction ch2.nii.gz head-late.nrrd head.vp --picture head-late.png
run CumulativeHeatDiffusion ch2.nii.gz head-early.nrrd --p 20 --timeSteps 2000
run HeatTransferFunction ch2.nii.gz head-early.nrrd head.vp --lines 0.39-0.5:lime:0.9,0.58-0.8:red:0.15 --picture head-early.png
panels 2 420 "$(rendering head-late.png)=400,000 steps" "$(rendering head-early.png)=2,000 steps, two lines" \
  "$(slices head-late.png)" "$(slices head-early.png)"
differs 'Published: p = 6, 400,000 steps. Ours: another head, p = 20 ([what p does](heat-diffusion.md#what-p-does)),' \
  '400,000 and 2,000 steps. **Differs:** after 400,000 steps, brain, skull and neck are one class. At 2,000 steps,' \
  'one line (green) contains eyes, muscles and the front of the brain, another (red) the scalp.'

figure 2.10 'vessels'
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128
run CumulativeHeatDiffusion vessels.nrrd vessels-heat.nrrd --p 7.5 --timeSteps 2000 --histogram vessels-histogram.png \
  --histogramRange 0.045,0.3
run HeatTransferFunction vessels.nrrd vessels-heat.nrrd vessels.vp --lines 0.05-0.0569:yellow:1,0.0569-0.0854:red:1,0.0854-1:lime:1 \
  --picture vessels.png
panels 2 400 "$(rendering vessels.png)" "$(histogram vessels-histogram.png)=heats from 0.045 to 0.3"
differs 'Published: aneurysm, p = 7.5, 100,000 steps. Ours: a phantom, p = 7.5, 2,000 steps. **Agrees:** heat' \
  'distinguishes blob, large vessel and thin vessels. **Differs:** after 100,000 steps, connected vessels have the' \
  'same heat.'
