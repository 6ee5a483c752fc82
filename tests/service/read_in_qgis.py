"""What QGIS makes of a running server and of its GeoPackage; run offscreen by clients tests.

    read_in_qgis.py URL PACKAGE PICTURE

Prints JSON: for every layer whether it is valid, its features, fields, extent and renderer. Draws
the layers of the package as they are styled into PICTURE.
"""

import json
import os
import sys

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from qgis.core import (  # noqa: E402
    QgsApplication,
    QgsFeatureRequest,
    QgsMapRendererParallelJob,
    QgsMapSettings,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QSize  # noqa: E402
from qgis.PyQt.QtGui import QColor  # noqa: E402

LAYERS = ("runout_zones", "release_zones", "sections")


def described(layer):
    if not layer.isValid():
        return {"valid": False, "error": layer.error().message()}
    features = list(layer.getFeatures())
    box = layer.extent()
    half = QgsRectangle(box.xMinimum(), box.yMinimum(), box.xMaximum(), box.center().y())
    inside = [f for f in features if f.geometry().intersects(half)]
    return {
        "valid": True,
        "features": len(features),
        "geometries": sum(f.hasGeometry() for f in features),
        "fields": [field.name() for field in layer.fields()],
        "crs": layer.crs().authid(),
        "renderer": layer.renderer().type(),
        "colours": sorted({symbol.color().name() for symbol in layer.renderer().symbols(
            __import__("qgis.core").core.QgsRenderContext())}),
        "in_south_half": len(inside),
        "asked_for_south_half": len(list(layer.getFeatures(QgsFeatureRequest(half)))),
    }


def draw(layers, picture):
    settings = QgsMapSettings()
    settings.setLayers(list(reversed(layers)))
    settings.setDestinationCrs(layers[0].crs())
    settings.setBackgroundColor(QColor("white"))
    settings.setOutputSize(QSize(900, 700))
    box = QgsRectangle(layers[0].extent())
    for layer in layers[1:]:
        box.combineExtentWith(layer.extent())
    box.scale(1.1)
    settings.setExtent(box)
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    job.renderedImage().save(picture)


def main(url, package, picture):
    application = QgsApplication([], False)
    application.initQgis()
    served = {
        name: QgsVectorLayer(f"url='{url}' typename='{name}' pagingEnabled='true' pageSize='2'",
                             name, "OAPIF")
        for name in LAYERS
    }
    packed = {name: QgsVectorLayer(f"{package}|layername={name}", name, "ogr") for name in LAYERS}
    print(json.dumps({"served": {name: described(layer) for name, layer in served.items()},
                      "package": {name: described(layer) for name, layer in packed.items()}}))
    sys.stdout.flush()
    draw(list(packed.values()), picture)
    served.clear()
    packed.clear()
    application.exitQgis()


main(*sys.argv[1:])
