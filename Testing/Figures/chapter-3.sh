# Chapter 3: shapetons; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 3 'shapetons'
write 'Colors are density classes. [CHD or shapetons?](shapetons.md) defines the *published* and the *controlled* walk. Figures 3.6 to' \
  '3.8 and 3.11 (d) show the published walk with 65,000 shapetons unless stated, 3.11 (a) the controlled walk.' ''

figure 3.4 'four shapes by shapetons'
shapes=()
for shape in figure3.4 figure3.5; do
  run ShapePhantom $shape.nrrd --shape $shape --size 96,96,96
  run ShapetonDiffusion $shape.nrrd $shape-published.nrrd --preset published --report $shape-published
  run ShapetonDiffusion $shape.nrrd $shape-controlled.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
    --p 7 --preset objects --report $shape-controlled
  shapes+=("$(rendering $shape-published/rendering.png)=$shape published" "$(rendering $shape-controlled/rendering.png)=$shape controlled")
done
panels 2 400 "${shapes[@]}"
differs '3.4 above, 3.5 below. Ours: published walk with 65,000 shapetons and 2,500 steps; controlled walk with 50,000' \
  'and 1,000. **Differs:** the published walk finds one class. The controlled walk distinguishes objects by surface' \
  'over volume: the cube from the sphere, but not from the large cuboid. Both spheres of 3.5 have the same class;' \
  'the deformed cuboid differs from the cuboid.'

figure 3.6 'number of shapetons'
run ShapePhantom cube128.nrrd --shape figure2.4 --size 128,128,128
many=()
for shapetons in 4000 8000 15000 30000; do
  run ShapetonDiffusion cube128.nrrd many-$shapetons.nrrd --shapetons $shapetons --timeSteps 1600 --preset published \
    --preview many-$shapetons.png --previewEvery 1000
  many+=("$(visits "many-$shapetons.png")=$shapetons")
done
panels 2 400 "${many[@]}"
differs 'Visits of a cube in 128^3, 1,600 steps. **Agrees:** more shapetons cover more voxels of the cube (92 %, 99 %,' \
  '100 %, 100 %). The walk shows no shape inside the cube.'

figure 3.7 'distance'
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128
run ShapePhantom vessels.nrrd --shape vessels --size 128,128,128 --labels vessels-labels.nrrd
steps=()
for distance in 0.001 0.005 0.01 0.05; do
  run ShapetonDiffusion vessels.nrrd vessels-$distance.nrrd --timeSteps 400 --distance $distance --p 7.5 \
    --preset published --mask vessels-labels.nrrd --preview vessels-$distance.png --previewEvery 1000
  steps+=("$(visits "vessels-$distance.png")=distance $distance")
done
panels 2 400 "${steps[@]}"
differs 'Ours: a phantom, p = 7.5, 400 steps, shapetons start in the vessels. **Agrees:** thin vessels are visible at' \
  'small distances and lost at large ones, because steps jump over walls.'

figure 3.7-aneurysm 'the aneurysm'
needs scivis/aneurism.nii.gz
run ShapetonDiffusion aneurism.nii.gz aneurysm-visits.nrrd --intensityWindow 20,120 --p 10 --smoothing 0.5 --shapetons 60000 \
  --timeSteps 400 --report aneurysm-shapetons
panels 1 700 "$(rendering aneurysm-shapetons/rendering.png)=objects, 60,000 shapetons, 400 steps of two voxels"
differs 'Ours: preset `objects`, window 20 to 120, p = 10, smoothing 0.5 mm. **Agrees:** thin vessels are visible, with more' \
  'visits (green to red) than their surroundings. **Differs:** the walls of thin vessels leak into a halo (blue), and the' \
  'aneurysm itself is in the lowest class, probably because it has less surface per volume.'

figure 3.8 'p with shapetons'
needs volumes/engine.nii.gz
pipes=()
for p in 4 9 15 20; do
  run ShapetonDiffusion engine.nii.gz engine-shapetons-$p.nrrd --p $p --timeSteps 1300 --distance 0.05 \
    --preset published --preview engine-shapetons-$p.png --previewEvery 1000
  pipes+=("$(visits "engine-shapetons-$p.png")=p = $p")
done
panels 2 400 "${pipes[@]}"
differs 'Ours: 1,300 steps, distance 0.05. **Differs:** pipe, rim and beam do not appear one after the other. From p = 15' \
  'on, visits accumulate where noise isolates voxels, and less of the engine is reached (100 %, 100 %, 97 %, 81 %).'

figure 3.11 'hydrogen and head'
needs volumes/ch2.nii.gz
run ShapePhantom hydrogen.nrrd --shape hydrogen --size 96,96,96
run ShapetonDiffusion hydrogen.nrrd hydrogen-visits.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
  --p 7 --preset objects --report hydrogen
run ShapetonDiffusion ch2.nii.gz head-visits.nrrd --p 6 --timeSteps 4160 --preset published --report head-shapetons
panels 2 400 "$(rendering hydrogen/rendering.png)=(a) hydrogen, controlled walk" "$(rendering head-shapetons/rendering.png)=(d) head, as published"
differs '(a) 50,000 shapetons, 1,000 steps. **Agrees:** the lobes have one class, different from nucleus and orbit. (d) p' \
  '= 6, 4,160 steps. **Differs:** the head and the surrounding air are one class.'
