from qt import Widget


class ctkPathLineEdit(Widget):
    Dirs = 1


ctkCollapsibleButton = ctkCollapsibleGroupBox = Widget
