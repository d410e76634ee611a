#!/bin/bash
# Called by ctest: CheckTemplates.sh REPORT.dcm
# Checks that PixelMed's template validator finds no error in a Structured Report.
set -u
jars=/usr/share/java
if ! command -v java >/dev/null || [ ! -f $jars/pixelmed.jar ]; then
  echo "java or PixelMed is not installed"
  exit
fi
path=$jars/pixelmed.jar
for jar in jaxb-api hsqldb vecmath commons-codec commons-net commons-compress slf4j-simple javax.json; do
  path=$path:$jars/$jar.jar
done
# Java's XPath limits are too low for the template rules.
said=$(java -Xmx3g -Djdk.xml.xpathTotalOpLimit=0 -Djdk.xml.xpathExprOpLimit=0 -Djdk.xml.xpathExprGrpLimit=0 -cp "$path" \
  com.pixelmed.validate.DicomSRValidator "$1" 2>&1)
printf '%s\n' "$said"
case $said in
  *Error*) exit 1 ;;
  *"Root Template Validation Complete"*) ;;
  *) exit 1 ;;
esac
