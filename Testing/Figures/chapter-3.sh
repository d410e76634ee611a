# Chapter 3: shapetons; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 3 'shapetons'
write 'Colors are density classes. [CHD or shapetons?](shapetons.md) defines the *published* and the *controlled* walk. Figures 3.6 to' \
  '3.8 show the published walk, 3.9 and 3.11 the controlled walk.' ''

figure 3.4 'four shapes by shapetons'
run ShapePhantom figure3.4.nrrd --shape figure3.4 --size 96,96,96
run ShapePhantom figure3.4.nrrd --shape figure3.4 --size 96,96,96 --labels figure3.4-labels.nrrd
run ShapetonDiffusion figure3.4.nrrd figure3.4-published.nrrd --preset published --report figure3.4-published
run ShapetonDiffusion figure3.4.nrrd figure3.4-inside.nrrd --preset published --shapetons 200000 --mask figure3.4-labels.nrrd \
  --report figure3.4-inside
run ShapetonDiffusion figure3.4.nrrd figure3.4-controlled.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
  --p 7 --preset objects --report figure3.4-controlled
panels 3 290 "$(rendering figure3.4-published/rendering.png)=published walk" \
  "$(rendering figure3.4-inside/rendering.png)=published walk from the objects" \
  "$(rendering figure3.4-controlled/rendering.png)=controlled walk"
differs '**Differs:** started anywhere, the published walk finds one class; started in the objects, it separates them from their' \
  'surroundings, not from each other. The controlled walk has one class for cube and large cuboid, another for sphere and' \
  'small cuboid; the dissertation has one for both cuboids, a similar one for the cube, another for the sphere.'

figure 3.5 'deformed shapes by shapetons'
run ShapePhantom figure3.5.nrrd --shape figure3.5 --size 96,96,96
run ShapePhantom figure3.5.nrrd --shape figure3.5 --size 96,96,96 --labels figure3.5-labels.nrrd
deformed=()
for shapetons in 1000 50000; do
  run ShapetonDiffusion figure3.5.nrrd figure3.5-published-$shapetons.nrrd --shapetons $shapetons --preset published \
    --report figure3.5-published-$shapetons
  run ShapetonDiffusion figure3.5.nrrd figure3.5-inside-$shapetons.nrrd --shapetons $shapetons --preset published \
    --mask figure3.5-labels.nrrd --report figure3.5-inside-$shapetons
  run ShapetonDiffusion figure3.5.nrrd figure3.5-controlled-$shapetons.nrrd --shapetons $shapetons --timeSteps 2500 --distance 0.01 \
    --p 7 --preset objects --report figure3.5-controlled-$shapetons
  for walk in published inside controlled; do
    deformed+=("$(rendering figure3.5-$walk-$shapetons/rendering.png)=${walk/inside/published, from the objects}, $shapetons")
  done
done
panels 3 290 "${deformed[@]}"
differs 'Published: 1,000 shapetons, 2,500 steps. **Agrees:** with 50,000, the published walk from the objects shows them, and' \
  'the controlled walk finds one class for both spheres and others for the cuboids. **Differs:** with 1,000, the published' \
  'walk shows noise; started anywhere, it finds one class; the deformed cuboid has its own class.'

figure 3.6 'number of shapetons'
run ShapePhantom cube128.nrrd --shape figure2.4 --size 128,128,128
many=()
for shapetons in 4000 8000 15000 30000; do
  run ShapetonDiffusion cube128.nrrd many-$shapetons.nrrd --shapetons $shapetons --timeSteps 1600 --preset published \
    --preview many-$shapetons.png --previewEvery 1000
  many+=("$(visits "many-$shapetons.png")=$shapetons")
done
panels 2 300 "${many[@]}"
differs 'Visits of a cube, 1,600 steps. **Agrees:** more shapetons cover more of it (92, 99, 100, 100 %). The walk shows no' \
  'shape inside the cube.'

figure 3.7 'distance'
needs scivis/aneurism.nii.gz
run threshold.py aneurism.nii.gz aneurysm-vessels.nii 40 255
steps=()
for distance in 0.001 0.005 0.01 0.05; do
  run ShapetonDiffusion aneurism.nii.gz aneurysm-$distance.nrrd --timeSteps 400 --distance $distance --p 7.5 \
    --preset published --mask aneurysm-vessels.nii
  run HeatTransferFunction aneurism.nii.gz aneurysm-$distance.nrrd aneurysm-visits.vp --lines 0.02-1:tomato:0.8 \
    --picture aneurysm-$distance.png
  steps+=("$(rendering "aneurysm-$distance.png")=distance $distance")
done
panels 2 400 "${steps[@]}"
differs '65,000 shapetons start in the vessels. Shown: more than 2 % of the most visits. **Agrees:** thin vessels are visible at' \
  'the smallest distance and lost at larger ones, because steps jump over walls. **Differs:** they are lost from 0.005 on,' \
  'not 0.01.'

figure 3.8 'p with shapetons'
needs volumes/engine.nii.gz
pipes=()
for p in 4 9 15 20; do
  run ShapetonDiffusion engine.nii.gz engine-shapetons-$p.nrrd --p $p --timeSteps 1300 --distance 0.05 \
    --preset published --preview engine-shapetons-$p.png --previewEvery 1000
  pipes+=("$(visits "engine-shapetons-$p.png")=p = $p")
done
panels 2 400 "${pipes[@]}"
differs '**Differs:** pipe, rim and beam do not appear one after the other. From p = 15 on, visits accumulate where noise' \
  'isolates voxels, and less of the engine is reached (100, 100, 97, 81 %).'

figure 3.9 'a CT of the chest'
needs ct/no-colon/chest.nii.gz
run threshold.py chest.nii.gz chest-bright.nii 120 4000
run ShapetonDiffusion chest.nii.gz chest-visits.nrrd --mask chest-bright.nii --intensityWindow 100,300 --p 8 --smoothing 1 \
  --shapetons 200000 --timeSteps 300
run HeatTransferFunction chest.nii.gz chest-visits.nrrd chest.vp \
  --lines '0.009-0.024:#c03a3a:0.3,0.026-0.048:#3a9a5a:0.7,0.048-0.2:#f0d060:0.9' --picture chest.png
panels 1 700 "$(rendering chest.png)" "$(slices chest.png)"
differs '200,000 shapetons that start above 120 HU, 300 steps of two voxels, window 100 to 300, p = 8, smoothing 1 mm.' \
  '**Agrees:** most ribs and the sternum have one class (yellow), heart, aorta and spleen another (red). **Differs:**' \
  'bones have specks of other classes; clavicles, shoulder blades, vertebrae and xiphoid have no class of their own.'

figure 3.10 'a polyp'
walter_reed
run box-of-volume.py walter-reed/segmentation/cleansed.nrrd polyp-box.nrrd -174.7,-124.6,100.3 30 polyp-tissue.nrrd -400
run ShapetonDiffusion polyp-box.nrrd polyp-visits.nrrd --preset published --p 15 --distance 0.033 --timeSteps 4000 \
  --intensityWindow=-1000,200 --mask polyp-tissue.nrrd
run few-visits.py polyp-box.nrrd polyp-visits.nrrd -100 60 polyp-visits.png
panels 3 270 "polyp-visits.png@0,0,300,300=(a) blue: tissue with few visits, axial" "polyp-visits.png@612,0,300,300=sagittal" \
  "walter-reed/polyps/report/polyp-candidate-1.png@1036,28,402,300=(b) marked by the default preset"
differs 'Walter Reed, candidate 1, on a stalk, in the cleansed CT; 65,000 shapetons started in tissue, fewer than 60 visits.' \
  '**Agrees:** the polyp is blue. **Differs:** so are thin folds; started anywhere, as published, so is all tissue. See [how' \
  'many polyps this finds](validation/colon-polyps.md#polyp-candidates-by-shapetons).'

# feet_by_shapetons: bones of the feet, started above 150 HU.
feet_by_shapetons() {
  needs ct/visible-female-ankle
  run DicomSeriesToImage visible-female-ankle feet.nii.gz
  run threshold.py feet.nii.gz feet-bright.nii 150 4000
  run ShapetonDiffusion feet.nii.gz feet-visits.nrrd --mask feet-bright.nii --intensityWindow 50,500 --p 8 --smoothing 0.5 \
    --shapetons 300000 --timeSteps 250
  run HeatTransferFunction feet.nii.gz feet-visits.nrrd feet-visits.vp --lines '0.005-0.02:#3c6bdf:0.6,0.02-0.2:#f0d060:0.8' \
    --picture feet-visits.png
}

figure 3.11 'hydrogen, abdomen, head, foot'
needs ct/totalsegmentator/example_ct.nii.gz volumes/ch2.nii.gz ct/visible-female-ankle
run ShapePhantom hydrogen.nrrd --shape hydrogen --size 96,96,96
run ShapetonDiffusion hydrogen.nrrd hydrogen-visits.nrrd --shapetons 50000 --timeSteps 1000 --distance 0.01 \
  --p 7 --preset objects --report hydrogen
run threshold.py example_ct.nii.gz abdomen-dense.nii 10 4000
run ShapetonDiffusion example_ct.nii.gz abdomen-visits.nrrd --mask abdomen-dense.nii --intensityWindow -50,150 --p 8 --smoothing 2 \
  --shapetons 300000 --timeSteps 300
run HeatTransferFunction example_ct.nii.gz abdomen-visits.nrrd abdomen.vp \
  --lines '0.019-0.036:#e0b050:0.03,0.036-0.05:#b04a3a:0.08,0.052-0.066:#3aa05a:0.15,0.069-0.15:#f2ead0:0.9' --picture abdomen.png
run threshold.py ch2.nii.gz brain-start.nii 80 125 50,130,55,160,60,130
run ShapetonDiffusion ch2.nii.gz brain-visits.nrrd --mask brain-start.nii --intensityWindow 30,90 --p 8 --smoothing 1 \
  --shapetons 150000 --timeSteps 700
run HeatTransferFunction ch2.nii.gz brain-visits.nrrd brain.vp --lines '0.0002-0.0015:#3c6bdf:0.03,0.002-0.1:#f0b060:0.8' \
  --picture brain.png
feet_by_shapetons
panels 2 330 "$(rendering hydrogen/rendering.png)=(a) hydrogen, a phantom" "$(slices hydrogen/rendering.png)" "$(rendering abdomen.png)=(c) abdomen" \
  "$(slices abdomen.png)" "$(rendering brain.png)=(d) head, started in the brain" "$(slices brain.png)" \
  "$(rendering feet-visits.png)=(e) feet" "$(slices feet-visits.png)"
differs 'p = 8; windows (c) -50 to 150, (d) 30 to 90, (e) 50 to 500. (a) **Agrees:** the lobes have one class, different from' \
  'nucleus and orbit. **Differs:** a phantom. (b) Our data contain no hand. (c) **Agrees:** bones (white), psoas muscles' \
  '(green), most of the liver (red) and the bladder (amber) differ. **Differs:** pancreas, aorta and kidneys have no class' \
  'of their own. (d) **Agrees:** the brain (amber) is separated. **Differs:** only because the shapetons start within it;' \
  'eye sockets are not visible. (e) **Agrees:** the bones of the feet of the Visible Human Female are visible.'

figure 3.12 'shapetons and heat'
feet_by_shapetons
run CumulativeHeatDiffusion feet.nii.gz feet-heat.nrrd --intensityWindow 50,500 --p 9 --timeSteps 1000
run HeatTransferFunction feet.nii.gz feet-heat.nrrd feet-heat.vp --lines '0.222-0.6:#3c6bdf:0.5,0.6-1:#f0d060:0.9' --picture feet-heat.png
panels 2 430 "$(rendering feet-visits.png)=(a) shapetons, 250 steps" "$(rendering feet-heat.png)=(b) heat, 1,000 steps"
differs 'Feet instead of the hand, window 50 to 500 HU. **Agrees:** both show the bones.'

figure table-3.1 'number of shapetons'
run ShapePhantom cube128.nrrd --shape figure2.4 --size 128,128,128
numbers=()
for pair in 4000,7100 8000,4400 15000,2800 30000,1600 65000,1500 150000,1200; do
  shapetons=${pair%,*}
  run ShapetonDiffusion cube128.nrrd "cube-$shapetons.nrrd" --preset published --shapetons "$shapetons" --timeSteps "${pair#*,}" \
    --threads 2
  numbers+=("$shapetons=cube-$shapetons")
done
table numbers "${numbers[@]}"
differs 'The cube of Figure 2.4, published walk; wall seconds of two busy threads. **Agrees:** with fewer shapetons, a step is' \
  'faster; the published steps visit 99.99 to 100 % of the cube. **Differs:** on a CPU, the time of a step grows at least' \
  'linearly with the number of shapetons, so adding shapetons saves no time. Not measured on a GPU; [65,536 shapetons' \
  'take 0.011 ms per step on an H100](benchmarks.md#on-a-gpu).'

figure table-3.2 'times of heat and shapetons'
needs scivis/foot.nii.gz volumes/engine.nii.gz scivis/aneurism.nii.gz scivis/mri_ventricles.nii.gz \
  ct/totalsegmentator/example_ct.nii.gz ct/no-colon/chest.nii.gz
# both_of NAME P HEAT_STEPS SHAPETON_STEPS: both diffusions of a volume, as published.
both_of() {
  run CumulativeHeatDiffusion "$1.nii.gz" "$1-heat.nrrd" --preset published --p "$2" --timeSteps "$3" --threads 2
  run ShapetonDiffusion "$1.nii.gz" "$1-shapetons.nrrd" --preset published --p "$2" --timeSteps "$4" --threads 2
}
both_of foot 7 100000 2800
both_of engine 10 52000 1100
both_of aneurism 7.5 100000 3100
both_of mri_ventricles 6 400000 4160
both_of example_ct 8 100000 2600
both_of chest 6 100000 1600
table volumes 'foot=256^3=foot' 'engine=256 x 256 x 128=engine' 'aneurysm=256^3=aneurism' 'MR head=256 x 256 x 124=mri_ventricles' \
  'CT abdomen=122 x 101 x 112=example_ct' 'CT chest=256 x 256 x 133=chest'
differs 'Wall seconds of two busy threads; head and CTs differ in size from the published volumes. The H200 column is for' \
  '[phantoms](benchmarks.md#table-21-of-the-dissertation-with-our-column). **Agrees:** shapetons take less time than heat' \
  'in the large volumes. **Differs:** they are 1.7 to 2.6 times faster, not 90 to 5,400 times, because our heat takes 6' \
  'to 18 times less than published.'
