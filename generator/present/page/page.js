// Shows the tip of a mark of a picture: by pointing, by touching, or by the arrow keys on a picture.
(function () {
  "use strict";
  var box = document.getElementById("tip");
  var chosen = null;

  // The browser would show a <title> beside our own tip.
  document.querySelectorAll(".chart title").forEach(function (title) {
    var mark = title.parentNode;
    mark.dataset.tip = title.textContent;
    mark.setAttribute("aria-label", title.textContent.replace(/\n/g, ", "));
    title.remove();
  });

  function place(x, y) {
    var width = box.offsetWidth;
    var height = box.offsetHeight;
    var left = Math.min(Math.max(4, x - width / 2), window.innerWidth - width - 4);
    var above = y - height - 14;
    box.style.left = Math.max(4, left) + "px";
    box.style.top = (above > 4 ? above : y + 18) + "px";
  }

  function show(mark, x, y) {
    hide();
    chosen = mark;
    chosen.classList.add("chosen");
    mark.dataset.tip.split("\n").forEach(function (line) {
      var span = document.createElement("span");
      span.textContent = line;
      box.appendChild(span);
    });
    box.hidden = false;
    place(x, y);
  }

  function showAt(mark) {
    mark.scrollIntoView({ block: "nearest", inline: "nearest" });
    var at = mark.getBoundingClientRect();
    show(mark, at.left + at.width / 2, at.top);
  }

  function hide() {
    if (chosen !== null) {
      chosen.classList.remove("chosen");
    }
    chosen = null;
    box.hidden = true;
    box.textContent = "";
  }

  function markOf(target) {
    var mark = target.closest ? target.closest("[data-tip]") : null;
    return mark;
  }

  document.addEventListener("pointermove", function (event) {
    var mark = markOf(event.target);
    if (mark !== null && mark !== chosen) {
      show(mark, event.clientX, event.clientY);
    } else if (mark !== null) {
      place(event.clientX, event.clientY);
    } else if (chosen !== null && event.pointerType === "mouse") {
      hide();
    }
  });

  document.addEventListener("pointerdown", function (event) {
    var mark = markOf(event.target);
    if (mark === null) {
      hide();
    } else {
      show(mark, event.clientX, event.clientY);
    }
  });

  // Left and right go from mark to mark, up and down to the next series at nearly the same place.
  function nextMark(marks, key) {
    var at = marks.indexOf(chosen);
    if (at === -1) {
      return marks[0];
    }
    if (key === "ArrowRight" || key === "ArrowLeft") {
      return marks[at + (key === "ArrowRight" ? 1 : -1)] || chosen;
    }
    var here = chosen.getBoundingClientRect();
    var others = marks.filter(function (mark) {
      return mark.parentNode !== chosen.parentNode;
    });
    var step = key === "ArrowDown" ? 1 : -1;
    var best = null;
    var least = Infinity;
    others.forEach(function (mark) {
      var there = mark.getBoundingClientRect();
      var down = (there.top - here.top) * step;
      var distance = down + 4 * Math.abs(there.left - here.left);
      if (down > 0.5 && distance < least) {
        least = distance;
        best = mark;
      }
    });
    return best || chosen;
  }

  document.querySelectorAll("svg.chart").forEach(function (picture) {
    picture.addEventListener("keydown", function (event) {
      if (event.key === "Escape") {
        hide();
      }
      if (["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"].indexOf(event.key) === -1) {
        return;
      }
      var marks = Array.from(picture.querySelectorAll(".point[data-tip]"));
      if (marks.length > 0) {
        event.preventDefault();
        showAt(nextMark(marks, event.key));
      }
    });
    picture.addEventListener("blur", hide);
  });
}());
